#pragma once
/// The theorem through time: one motion in several formulations, each stepped by itself, and lambda,
/// positions and accelerations side by side at every output. Decides the two bounds.
///
/// Along the motion the runs are apart by the errors of their steps. Where a method chooses steps to a
/// tolerance, every step may err by it, and what the motion makes of an error is measured by a run from a
/// neighbouring start:
///
///   bound of lambda = steps . tolerance . amplification
///
/// Where steps are given, every formulation runs with half of them too, and the bound is twice the sum of
/// what that changes in the two that are compared. At one state, where every formulation is solved at the
/// states of all others, the bound is 100 u kappa.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "formulations/side_by_side.hpp"
#include "simulation/simulate.hpp"

namespace trivium {

/// A formulation as the comparison needs it: by its name those of the library, or any.
struct ComparedFormulation {
  std::string name;
  std::function<SimulationReport(const Model<double>&, const SimulationOptions&, SimulationObserver&)>
      simulate;
  /// At one state, as printed.
  std::function<FormulationResult<double>(const Model<double>&, const RowAnalysis&, const ChartOptions&)>
      solve;
};

/// Those of the library that have one of these names and go with the method; all where there are no names.
std::vector<ComparedFormulation> compared_formulations(const std::vector<std::string>& names,
                                                       const integrators::MethodInfo& method);

struct ComparisonOptions {
  SimulationOptions run;  ///< its formulation is not used; its outputs are compared
  int outputs = 100;      ///< where the run gives no output step
  int states = 10;        ///< so many outputs, evenly, are solved in every formulation at every one's state
  std::function<void(double)> progress;  ///< told the share that is done, 0 to 1
};

/// All formulations at one time. Differences are the largest between two.
struct ComparedInstant {
  double t = 0;
  double lambda = 0, lambda_bound = 0;  ///< along the motion: in the norm of E, relative
  double amplification = 1;             ///< of a relative difference of the start, in lambda, so far
  double position = 0, rotation = 0;    ///< [m, rad]
  bool is_singular =
      false;  ///< a run passed a singular position here, where lambda is not unique: not judged
  struct OneState {
    double lambda = 0, bound = 0;  ///< of the state whose difference is the largest beside its bound
    double acceleration =
        0;  ///< in the mass metric, relative; of constrained mechanisms held to the bound, too
    bool is_constrained = true;
    bool holds() const { return lambda <= bound && (!is_constrained || acceleration <= bound); }
    double kappa = 1;  ///< the largest
  };
  std::optional<OneState> one_state;
};

struct ComparedRun {
  std::string formulation;
  SimulationReport report;
  std::vector<std::string> charts;  ///< that bodies had at outputs, each once
  std::string error;                ///< why it did not come to the end; empty where it did
};

/// Whether all came to the end.
bool are_complete(const std::vector<ComparedRun>& runs);

/// The model at a state of a motion, the angles of its joints counted on (MotionSample::angles).
Model<double> model_at(const Model<double>& model, const MechanismState<double>& state,
                       const std::vector<double>& angles);

struct MotionComparison {
  std::vector<ComparedRun> runs;
  std::vector<ComparedInstant> instants;
  bool has_unique_lambda = true;       ///< else there is nothing to compare
  double neighbour_distance = 0;       ///< of the neighbouring start, relative; 0: the constraints leave none
  std::optional<double> judged_until;  ///< from here on a neighbouring start has led elsewhere: not judged
  std::vector<std::vector<MotionSample>> samples;  ///< of every run

  bool complete() const { return are_complete(runs); }
  /// Whether lambda along the motion has a bound there.
  bool is_judged(const ComparedInstant& now) const;
  /// Whether lambda is within its bound at every output, and at every state.
  bool holds_along() const;
  bool holds_at_states() const;
};

/// Throws a ModelError where the start cannot be analysed; what a run throws is its error.
MotionComparison compare_motion(const std::vector<ComparedFormulation>& formulations,
                                const Model<double>& model, const ComparisonOptions& options);

}  // namespace trivium
