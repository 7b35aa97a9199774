#include "validation/simulation.hpp"

#include "formulations/r_epsilon_omega_first.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/r_p.hpp"
#include "formulations/side_by_side.hpp"

namespace trivium {

namespace {

template <Formulation F>
void simulate_if_named(const scenes::Scene& scene, const SimulationOptions& options,
                       SimulationObserver& observer, std::optional<SimulationReport>& report) {
  if (options.formulation == F::name) report = simulate_in<F>(scene, options, observer);
}

}  // namespace

template <class Scalar>
SimulationReport simulate(const scenes::Scene& scene, const SimulationOptions& options,
                          SimulationObserver& observer) {
  std::optional<SimulationReport> report;
  simulate_if_named<ROmega<Scalar>>(scene, options, observer, report);
  simulate_if_named<RP<Scalar>>(scene, options, observer, report);
  simulate_if_named<REpsilon<Scalar>>(scene, options, observer, report);
  simulate_if_named<REpsilonOmegaFirst<Scalar>>(scene, options, observer, report);
  if (!report)
    throw ModelError(fmt::format("there is no formulation \"{}\"; accepted: {}", options.formulation,
                                 fmt::join(formulation_names(), ", ")));
  return *report;
}

template SimulationReport simulate<double>(const scenes::Scene&, const SimulationOptions&,
                                           SimulationObserver&);
template SimulationReport simulate<Quad>(const scenes::Scene&, const SimulationOptions&, SimulationObserver&);

}  // namespace trivium
