/// Turns the name of the formulation into its type, and refuses methods that do not go with it.

#include "simulation/simulate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bodies/numbers/quad.hpp"
#include "formulations/formulation_list.hpp"
#include "integrators/methods.hpp"
#include "simulation/simulate_in.hpp"

namespace trivium {

bool inertia_is_constant(const std::string& formulation) {
  return with_formulation<double>(formulation, []<Formulation F>() { return F::inertia_is_constant; });
}

bool goes_with(const integrators::MethodInfo& method, const std::string& formulation) {
  return !method.needs_constant_inertia || inertia_is_constant(formulation);
}

namespace {

void check_that_it_goes(const integrators::MethodInfo& method, const std::string& formulation) {
  if (goes_with(method, formulation)) return;
  std::vector<std::string> accepted = formulation_names();
  std::erase_if(accepted, [](const std::string& name) { return !inertia_is_constant(name); });
  throw integrators::UsageError(fmt::format(
      "{} needs a formulation whose mass matrix does not depend on positions, unlike {}; accepted: {}",
      method.name, formulation, fmt::join(accepted, ", ")));
}

}  // namespace

template <class Scalar>
SimulationReport simulate(const Model<Scalar>& model, const SimulationOptions& options,
                          SimulationObserver& observer) {
  check_that_it_goes(options.own_method ? options.own_method->info
                                        : integrators::method_entry<double>(options.integrator).info,
                     options.formulation);
  return with_formulation<Scalar>(options.formulation,
                                  [&]<Formulation F>() { return simulate_in<F>(model, options, observer); });
}

template SimulationReport simulate<double>(const Model<double>&, const SimulationOptions&,
                                           SimulationObserver&);
template SimulationReport simulate<Quad>(const Model<Quad>&, const SimulationOptions&, SimulationObserver&);

}  // namespace trivium
