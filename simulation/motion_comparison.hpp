#pragma once
/// Comparison of one motion in several formulations. In exact arithmetic, unique multipliers lambda are the
/// same in all formulations (docs/lambda.md). Every formulation is integrated separately; lambda, positions
/// and orientations are compared at every output. This file decides two bounds.
///
/// Along the motion the runs differ by the errors of their steps. If the method controls its step size, every
/// step may have an error of the tolerance rtol + atol, and the motion amplifies it:
///
///     bound of lambda = steps . (rtol + atol) . amplification
///
/// Runs from neighbouring starts measure the amplification. Once the bound or the difference of a neighbour
/// exceeds small_difference (0.1, neighbouring_start.hpp), lambda is not judged any more. If steps are given,
/// every formulation also runs with half the step. The bound is then 2 (c_1 + c_2), where c_1 and c_2 are the
/// largest and the second largest relative change of lambda by half the step that any formulation shows; each
/// 2 c counts as at least 1e-12. Lambda is not judged any more once 2 c_1 exceeds small_difference.
///
/// At one state, every formulation is solved at the states of all runs, and the bound is 100 u kappa.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/raise.hpp"
#include "formulations/side_by_side.hpp"
#include "simulation/simulate.hpp"

namespace trivium {

/// A formulation to compare, given by its functions: one of the library's, or a user's own.
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

/// The options of a comparison.
struct ComparisonOptions {
  SimulationOptions run;  ///< settings of all runs; the formulation is ignored
  int outputs = 100;      ///< number of output intervals if the run has no output step
  /// Number of outputs, evenly spread, that are also compared at one state. Above 500 unknowns (6 nb + nc)
  /// fewer are compared, above most_dense_unknowns none.
  int states = 10;
  std::function<void(double)> progress;  ///< receives the finished share of the work, 0 to 1
};

/// All formulations at one output. Every difference is the largest between any two formulations.
struct ComparedInstant {
  double t = 0;                         ///< [s]
  double lambda = 0, lambda_bound = 0;  ///< relative difference in |E lambda| between runs [-]; its bound
  /// Largest relative change of lambda up to this output that a neighbouring start causes, divided by the
  /// relative distance of that start [-]; at least 1.
  double amplification = 1;
  /// Distance of centres of mass [m]; angle theta between orientations, as 4 sin(theta / 4) [rad].
  double position = 0, rotation = 0;
  bool is_singular = false;  ///< near a singular position, where lambda is not unique: not judged
  /// The comparison at one state.
  struct OneState {
    double lambda = 0, bound = 0;  ///< difference and bound at the state where `ratio` is largest
    double acceleration = 0;       ///< relative difference of accelerations there, in the mass metric
    bool is_constrained = true;    ///< the mechanism has rows; otherwise accelerations are not judged
    double kappa = 1;              ///< condition number there
    /// The larger of the differences that are judged, divided by the bound; NaN if one of them is NaN.
    double ratio() const {
      double largest = lambda;
      if (is_constrained) raise(largest, acceleration);
      return largest / bound;
    }
    bool holds() const { return ratio() <= 1; }
  };
  std::optional<OneState> one_state;
};

/// The run of one formulation.
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

/// The result of compare_motion.
struct MotionComparison {
  std::vector<ComparedRun> runs;
  std::vector<ComparedInstant> instants;  ///< one per output; empty unless all runs are complete
  bool has_unique_lambda = true;          ///< false: no multiplier is unique, so no lambda can be compared
  double neighbour_distance = 0;  ///< largest relative distance of a neighbouring start [-]; 0: there is none
  /// Time [s] from which lambda is not judged: neighbouring motions have diverged, or the bound is too large.
  std::optional<double> judged_until;
  std::vector<std::vector<MotionSample>> samples;  ///< per run: its outputs

  bool complete() const { return are_complete(runs); }
  /// Whether lambda along the motion is held to its bound at this output.
  bool is_judged(const ComparedInstant& now) const;
  /// Whether all runs are complete and lambda is within its bound at every judged output.
  bool holds_along() const;
  /// Whether all runs are complete, and lambda and accelerations are within their bounds at every compared
  /// state that is not near a singular position.
  bool holds_at_states() const;
};

/// Runs and compares. Throws a ModelError if the start cannot be analysed, and an Error of kind input of any
/// run. Other errors of the run of a formulation are stored in its ComparedRun::error. Errors of the runs
/// that only measure a bound (neighbouring starts, half the step) are thrown.
MotionComparison compare_motion(const std::vector<ComparedFormulation>& formulations,
                                const Model<double>& model, const ComparisonOptions& options);

}  // namespace trivium
