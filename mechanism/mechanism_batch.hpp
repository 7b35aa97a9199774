#pragma once
/// Packs mechanisms of equal structure into the lanes of a batch, for sweeps over masses, inertias, points,
/// axes and the coefficients of effects. Types, functions of time, the rank tolerance, and the names of
/// bodies, rows and joints must be the same in all of them; a difference is an error. The names of mechanism
/// and effects are those of the first.

#include <fmt/format.h>

#include <array>
#include <span>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "bodies/numbers/batch.hpp"
#include "mechanism/mechanism_cast.hpp"
#include "mechanism/parts.hpp"

namespace trivium {

namespace detail {

/// All parts of a mechanism in the order of show_parts, separated into numbers and structure.
template <class T>
struct TakenApart {
  using NotANumber = std::variant<int, std::string, TimeFunction>;
  std::vector<T> numbers;             ///< may differ between the lanes
  std::vector<NotANumber> structure;  ///< must be equal in all lanes

  template <class Types>
  explicit TakenApart(const Mechanism<T, Types>& mechanism) {
    const auto take = [this]<class Part>(const Part& part) {
      if constexpr (std::is_same_v<Part, T>)
        numbers.push_back(part);
      else if constexpr (std::is_enum_v<Part>)
        structure.emplace_back(static_cast<int>(part));
      else if constexpr (std::is_same_v<Part, std::array<TimeFunction, 3>>)
        structure.insert(structure.end(), part.begin(), part.end());
      else if constexpr (std::is_constructible_v<NotANumber, Part>)
        structure.emplace_back(part);
      else
        numbers.insert(numbers.end(), part.data(), part.data() + part.size());
    };
    show_parts(take, mechanism);
  }
};

}  // namespace detail

/// One mechanism whose lane k has the numbers of mechanisms[k]. Throws a ModelError if the mechanisms differ
/// in their structure. Functions of time and the rank tolerance belong to the structure, and so does the
/// length of a distance joint.
template <class T, int N, class Types = StandardTypes>
Mechanism<Batch<T, N>, Types> pack(std::span<const Mechanism<T, std::type_identity_t<Types>>, N> mechanisms) {
  auto all = mechanism_cast<Batch<T, N>>(mechanisms[0]);
  const detail::TakenApart<T> first(mechanisms[0]);
  for (int lane = 1; lane < N; ++lane) {
    const detail::TakenApart<T> parts(mechanisms[lane]);
    if (parts.structure != first.structure || parts.numbers.size() != first.numbers.size() ||
        mechanisms[lane].rank_tolerance != mechanisms[0].rank_tolerance)
      throw ModelError(fmt::format(
          "mechanism {} of a batch, \"{}\", differs from the first in names, joints, functions of "
          "time or the rank tolerance; only other numbers may differ",
          lane + 1, mechanisms[lane].name));
    auto next = parts.numbers.begin();
    const auto put = [&]<class Part>(Part& part) {
      if constexpr (std::is_same_v<Part, Batch<T, N>>)
        part.set(lane, *next++);
      else if constexpr (requires { part.data()->set(lane, *next); })
        for (Batch<T, N>& x : part.reshaped()) x.set(lane, *next++);
    };
    show_parts(put, all);
  }
  return all;
}

}  // namespace trivium
