#include "simulation/simulate.hpp"

#include "formulations/r_epsilon_omega_first.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/r_p.hpp"
#include "formulations/side_by_side.hpp"

namespace trivium {

namespace {

/// use.operator()<F>() of the formulation of that name.
template <class Scalar, class Use>
auto with_formulation(const std::string& name, const Use& use) {
  if (name == ROmega<Scalar>::name) return use.template operator()<ROmega<Scalar>>();
  if (name == RP<Scalar>::name) return use.template operator()<RP<Scalar>>();
  if (name == REpsilon<Scalar>::name) return use.template operator()<REpsilon<Scalar>>();
  if (name == REpsilonOmegaFirst<Scalar>::name) return use.template operator()<REpsilonOmegaFirst<Scalar>>();
  throw ModelError(fmt::format("there is no formulation \"{}\"; accepted: {}", name,
                               fmt::join(formulation_names(), ", ")));
}

}  // namespace

bool inertia_is_constant(const std::string& formulation) {
  return with_formulation<double>(formulation, []<Formulation F>() { return F::inertia_is_constant; });
}

template <class Scalar>
SimulationReport simulate(const Model<Scalar>& model, const SimulationOptions& options,
                          SimulationObserver& observer) {
  return with_formulation<Scalar>(options.formulation,
                                  [&]<Formulation F>() { return simulate_in<F>(model, options, observer); });
}

template SimulationReport simulate<double>(const Model<double>&, const SimulationOptions&,
                                           SimulationObserver&);
template SimulationReport simulate<Quad>(const Model<Quad>&, const SimulationOptions&, SimulationObserver&);

}  // namespace trivium
