#pragma once
/// A model's motion in one formulation by one method, both chosen by name. The motion is shown to an observer
/// (simulation/motion.hpp).

#include <optional>
#include <string>

#include "formulations/contract/chart_options.hpp"
#include "formulations/structured/baumgarte.hpp"
#include "integrators/contract/errors.hpp"
#include "integrators/method_entry.hpp"
#include "mechanism/model.hpp"
#include "simulation/motion.hpp"

namespace trivium {

struct SimulationOptions {
  std::string formulation = "r-omega", integrator = "dopri5";
  /// A method of the caller's, in the place of the one of that name.
  std::optional<integrators::MethodEntry<double>> own_method = {};
  double end = 10;
  std::optional<double> step;         ///< else the method chooses, to the tolerances
  std::optional<double> output_step;  ///< else the start and the end
  integrators::Tolerances tolerances;
  integrators::MethodParameters parameters;
  bool projects = true;  ///< methods that do not meet constraints by their own equations
  /// Whether drift and energy are looked at after every step, and lambda and reactions at outputs; a run that
  /// is timed leaves them out.
  bool watches = true;
  std::optional<Baumgarte> baumgarte;
  ChartOptions charts;
  /// A run that ended at the model's state, to go on from in its own numbers: methods that keep nothing from
  /// step to step then take given steps as if it had not ended. Of another formulation than this one: not
  /// used.
  std::optional<SavedRun> from;
};

/// Whether the mass matrix of a formulation does not depend on positions. Throws a ModelError where there is
/// no such formulation.
bool inertia_is_constant(const std::string& formulation);
/// Whether the method can move it.
bool goes_with(const integrators::MethodInfo& method, const std::string& formulation);

/// From the model's state, at its time. Throws a ModelError or an IntegrationError that says
/// where and why it ended; the samples until then were shown.
template <class Scalar>
SimulationReport simulate(const Model<Scalar>& model, const SimulationOptions& options,
                          SimulationObserver& observer);

}  // namespace trivium
