#pragma once
/// Comparison of one motion in several formulations. The theorem says that lambda is the same in all of them.
/// Every formulation is integrated separately; lambda, positions and accelerations are compared at every
/// output. This file decides two bounds.
///
/// Along the motion the runs differ by the errors of their steps. If the method controls its step size, every
/// step may have an error of the tolerance, and the motion amplifies it:
///
///     bound of lambda = steps . tolerance . amplification,   at most small_difference
///
/// A run from a neighbouring start measures the amplification. If steps are given, every formulation also
/// runs with half the step, and the bound is twice the sum of the two largest changes. At one state, where
/// every formulation is solved at the states of all others, the bound is 100 u kappa, enlarged where the
/// causes of lambda cancel (SideBySide::cancellation).

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "formulations/side_by_side.hpp"
#include "simulation/simulate.hpp"

namespace trivium {

/// A formulation to compare, as functions: one of the library's, or any other.
struct ComparedFormulation {
  std::string name;
  std::function<SimulationReport(const Model<double>&, const SimulationOptions&, SimulationObserver&)>
      simulate;
  /// Solves the printed system at one state.
  std::function<FormulationResult<double>(const Model<double>&, const RowAnalysis&, const ChartOptions&)>
      solve;
};

/// The library's formulations with one of these names (empty: all) that the method can be used with.
std::vector<ComparedFormulation> compared_formulations(const std::vector<std::string>& names,
                                                       const integrators::MethodInfo& method);

struct ComparisonOptions {
  SimulationOptions run;  ///< settings of all runs; the formulation is ignored
  int outputs = 100;      ///< number of output intervals if the run has no output step
  int states = 10;        ///< number of outputs, evenly spread, that are also compared at one state
  std::function<void(double)> progress;  ///< receives the finished share of the work, 0 to 1
};

/// All formulations at one output. Every difference is the largest between any two of them.
struct ComparedInstant {
  double t = 0;                         ///< [s]
  double lambda = 0, lambda_bound = 0;  ///< relative difference along the motion, in the norm of E; its bound
  double amplification = 1;             ///< growth of a relative difference of the start, in lambda, so far
  double position = 0, rotation = 0;    ///< [m, rad]
  bool is_singular = false;             ///< near a singular position, where lambda is not unique: not judged
  /// The comparison at one state.
  struct OneState {
    double lambda = 0, bound = 0;  ///< at the state where the difference is largest relative to its bound
    double acceleration = 0;       ///< relative, in the mass metric; bounded only if there are constraints
    bool is_constrained = true;
    bool holds() const { return lambda <= bound && (!is_constrained || acceleration <= bound); }
    double kappa = 1;  ///< largest condition number of these states
  };
  std::optional<OneState> one_state;
};

struct ComparedRun {
  std::string formulation;
  SimulationReport report;
  std::vector<std::string> charts;  ///< charts that bodies had at outputs, each once
  std::string error;                ///< why the run stopped before its end; empty if it did not
};

/// Whether all runs reached the end.
bool are_complete(const std::vector<ComparedRun>& runs);

/// The model moved to a state of a motion; `angles` are the joint angles counted there, as in MotionSample.
Model<double> model_at(const Model<double>& model, const MechanismState<double>& state,
                       const std::vector<double>& angles);

struct MotionComparison {
  std::vector<ComparedRun> runs;
  std::vector<ComparedInstant> instants;
  bool has_unique_lambda = true;  ///< false: no multiplier is unique, so no lambda can be compared
  double neighbour_distance = 0;  ///< relative distance of the neighbouring start [-]; 0 if there is none
  std::optional<double> judged_until;  ///< time from which neighbouring motions have diverged: not judged
  std::vector<std::vector<MotionSample>> samples;  ///< per run: its outputs

  bool complete() const { return are_complete(runs); }
  /// Whether lambda along the motion is held to its bound at this output.
  bool is_judged(const ComparedInstant& now) const;
  /// Whether all runs are complete and lambda is within its bound at every judged output.
  bool holds_along() const;
  /// The same at every compared state, for lambda and accelerations.
  bool holds_at_states() const;
};

/// Runs and compares. Throws a ModelError if the start cannot be analysed, and an Error of kind input of any
/// run; other errors of a run are stored in its ComparedRun::error.
MotionComparison compare_motion(const std::vector<ComparedFormulation>& formulations,
                                const Model<double>& model, const ComparisonOptions& options);

}  // namespace trivium
