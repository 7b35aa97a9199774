#pragma once
/// The one list of formulations. A new formulation is entered here; reports, comparisons and simulations take
/// their formulations from here, by name.

#include <string>
#include <tuple>
#include <vector>

#include "formulations/r_epsilon.hpp"
#include "formulations/r_epsilon_omega_first.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/r_p.hpp"

namespace trivium {

/// The formulations over one Scalar, in the order in which they are reported.
template <class Scalar>
using FormulationList = std::tuple<ROmega<Scalar>, RP<Scalar>, REpsilon<Scalar>, REpsilonOmegaFirst<Scalar>>;

/// Their names, in the same order.
std::vector<std::string> formulation_names();

namespace detail {
/// A ModelError that names the formulations there are.
[[noreturn]] void throw_no_formulation(const std::string& name);

template <class Scalar, std::size_t place, class Use>
auto with_formulation_from(const std::string& name, const Use& use) {
  using F = std::tuple_element_t<place, FormulationList<Scalar>>;
  if (name == F::name) return use.template operator()<F>();
  if constexpr (place + 1 < std::tuple_size_v<FormulationList<Scalar>>)
    return with_formulation_from<Scalar, place + 1>(name, use);
  else
    throw_no_formulation(name);
}
}  // namespace detail

/// use.operator()<F>() of the formulation of that name; throws a ModelError if there is none.
template <class Scalar, class Use>
auto with_formulation(const std::string& name, const Use& use) {
  return detail::with_formulation_from<Scalar, 0>(name, use);
}

}  // namespace trivium
