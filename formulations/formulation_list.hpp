#pragma once
/// Lists of formulations, and the one of the library. A new formulation is entered there; reports,
/// comparisons and simulations take their formulations from it, by name. Who has a formulation outside the
/// library hands AllFormulations::With<Mine> to what takes a list.

#include <string>
#include <tuple>
#include <vector>

#include "formulations/r_epsilon.hpp"
#include "formulations/r_epsilon_omega_first.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/r_p.hpp"

namespace trivium {

/// Formulations in the order in which they are reported, over any Scalar.
template <template <class> class... F>
struct Formulations {
  template <class Scalar>
  using In = std::tuple<F<Scalar>...>;
  template <template <class> class... More>
  using With = Formulations<F..., More...>;
  /// The same for mechanisms with other types of constraints and effects.
  template <class Types>
  using WithTypes = Formulations<Retyped<F, Types>::template In...>;
  static std::vector<std::string> names() { return {std::string(F<double>::name)...}; }
};

/// The list of the library, once: X(F, ...) for every formulation F. Types follow from it below; what is
/// compiled for each formulation (instances/, also from CMake) has no other way to repeat itself.
#define TRIVIUM_FORMULATIONS(X, ...) \
  X(ROmega, __VA_ARGS__)             \
  X(RP, __VA_ARGS__)                 \
  X(REpsilon, __VA_ARGS__)           \
  X(REpsilonOmegaFirst, __VA_ARGS__)

#define TRIVIUM_WITH(F, ...) ::With<F>
using AllFormulations = Formulations<> TRIVIUM_FORMULATIONS(TRIVIUM_WITH);
#undef TRIVIUM_WITH

/// Their names, in the same order.
std::vector<std::string> formulation_names();

namespace detail {
/// A ModelError that names the formulations there are.
[[noreturn]] void throw_no_formulation(const std::string& name, const std::vector<std::string>& names);

template <class Scalar, class List, std::size_t place, class Use>
auto with_formulation_from(const std::string& name, const Use& use) {
  using In = typename List::template In<Scalar>;
  using F = std::tuple_element_t<place, In>;
  if (name == F::name) return use.template operator()<F>();
  if constexpr (place + 1 < std::tuple_size_v<In>)
    return with_formulation_from<Scalar, List, place + 1>(name, use);
  else
    throw_no_formulation(name, List::names());
}
}  // namespace detail

/// use.operator()<F>() of the formulation of that name; throws a ModelError if there is none.
template <class Scalar, class List = AllFormulations, class Use>
auto with_formulation(const std::string& name, const Use& use) {
  return detail::with_formulation_from<Scalar, List, 0>(name, use);
}

}  // namespace trivium
