#pragma once
/// Simulation of a model in one formulation by one integrator, both chosen by name. An observer receives the
/// motion (simulation/motion.hpp).

#include <optional>
#include <string>

#include "formulations/contract/chart_options.hpp"
#include "formulations/structured/baumgarte.hpp"
#include "integrators/contract/errors.hpp"
#include "integrators/method_entry.hpp"
#include "mechanism/model.hpp"
#include "simulation/motion.hpp"

namespace trivium {

/// The options of a run. The names are those of formulation_names() and integrators::method_names().
struct SimulationOptions {
  std::string formulation = "r-omega", integrator = "dopri5";
  /// A method provided by the caller, instead of the one named by `integrator`; in double only.
  std::optional<integrators::MethodEntry<double>> own_method = {};
  double end = 10;                      ///< end time [s]
  std::optional<double> step;           ///< constant step size [s]; none: the method controls its step size
  std::optional<double> max_step = {};  ///< longest chosen step [s]; a UsageError with `step`
  std::optional<double> output_step;    ///< time between outputs [s]; none: outputs at start and end
  integrators::Tolerances tolerances;   ///< of chosen steps; not used with `step`
  integrators::MethodParameters parameters;
  /// Whether states are projected onto the constraints after every step. False is a UsageError with methods
  /// that satisfy Phi = 0 by their own equations (MethodInfo::meets_constraints): they have no projection to
  /// switch off.
  bool projects = true;
  /// Whether constraint violations and energy are evaluated after every step, and lambda and reactions at
  /// outputs. False in runs whose time is measured: samples then contain the state only.
  bool watches = true;
  /// Stabilisation of the accelerations. It does not switch the projection off: set `projects` to false as
  /// well. Methods that satisfy constraints by multipliers of their own refuse it with a UsageError.
  std::optional<Baumgarte> baumgarte;
  ChartOptions charts;  ///< sequence of the Euler angles of r-epsilon, and whether charts are changed
  /// The saved run that ended at the model's state, to continue with its numbers. One-step methods with given
  /// steps then give the same bits as without interruption. A saved run in another formulation is ignored.
  std::optional<SavedRun> from;
};

/// Whether the method can be used with the formulation: some methods need a constant mass matrix. Throws
/// a ModelError for an unknown name of a formulation.
bool goes_with(const integrators::MethodInfo& method, const std::string& formulation);

/// Simulates from the model's state and time to options.end. Throws a ModelError or an IntegrationError with
/// the time and the reason if the motion cannot continue, and a UsageError (kind input) if options contradict
/// each other. The observer has received all samples before the error.
template <class Scalar>
SimulationReport simulate(const Model<Scalar>& model, const SimulationOptions& options,
                          SimulationObserver& observer);

}  // namespace trivium
