#include "validation/simulation.hpp"

#include "formulations/r_epsilon_omega_first.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/r_p.hpp"

namespace trivium {

namespace {

/// Calls visit<F>() for every formulation.
template <template <class> class... Fs>
struct FormulationList {
  template <class Visit>
  static void for_each(const Visit& visit) {
    (visit.template operator()<Fs>(), ...);
  }
};
using Simulated = FormulationList<ROmega, RP, REpsilon, REpsilonOmegaFirst>;

}  // namespace

std::vector<std::string> simulated_formulations() {
  std::vector<std::string> names;
  Simulated::for_each([&]<template <class> class F>() { names.emplace_back(F<double>::name); });
  return names;
}

template <class Scalar>
SimulationReport simulate(const scenes::Scene& scene, const SimulationOptions& options,
                          SimulationObserver& observer) {
  std::optional<SimulationReport> report;
  Simulated::for_each([&]<template <class> class F>() {
    if (options.formulation == F<double>::name) report = simulate_in<F<Scalar>>(scene, options, observer);
  });
  if (!report)
    throw ModelError(fmt::format("there is no formulation \"{}\"; accepted: {}", options.formulation,
                                 fmt::join(simulated_formulations(), ", ")));
  return *report;
}

template SimulationReport simulate<double>(const scenes::Scene&, const SimulationOptions&,
                                           SimulationObserver&);
template SimulationReport simulate<Quad>(const scenes::Scene&, const SimulationOptions&, SimulationObserver&);

}  // namespace trivium
