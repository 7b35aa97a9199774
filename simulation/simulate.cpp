#include "simulation/simulate.hpp"

#include "bodies/numbers/quad.hpp"
#include "formulations/formulation_list.hpp"
#include "simulation/simulate_in.hpp"

namespace trivium {

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
