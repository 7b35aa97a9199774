#pragma once
/// Mechanisms of one structure side by side in the lanes of a batch, for sweeps over masses, inertias,
/// points, axes and the coefficients of effects. What is no number (types, names, functions of time) must be
/// the same in all; a difference is an error.

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

/// A mechanism taken apart.
template <class T>
struct TakenApart {
  using NotANumber = std::variant<int, std::string, TimeFunction>;
  std::vector<T> numbers;
  std::vector<NotANumber> structure;

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

/// As many mechanisms as there are lanes. Throws a ModelError where they differ in anything but numbers:
/// functions of time, and so the lengths of distance constraints, are one for all lanes.
template <class T, int N, class Types = StandardTypes>
Mechanism<Batch<T, N>, Types> pack(std::span<const Mechanism<T, std::type_identity_t<Types>>, N> mechanisms) {
  auto all = mechanism_cast<Batch<T, N>>(mechanisms[0]);
  const detail::TakenApart<T> first(mechanisms[0]);
  for (int lane = 1; lane < N; ++lane) {
    const detail::TakenApart<T> parts(mechanisms[lane]);
    if (parts.structure != first.structure || parts.numbers.size() != first.numbers.size())
      throw ModelError(
          fmt::format("mechanism {} of a batch, \"{}\", differs from the first in names, joints or functions "
                      "of time; only numbers outside functions of time may differ",
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
