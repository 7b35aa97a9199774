#pragma once
/// Comparison of one motion in several formulations, as in the program `trivium compare`. Every formulation
/// is integrated separately. Two questions are answered.
///
/// Along the motion: do the multipliers lambda of the separate runs agree? The bound of their difference is
/// the product of the number of steps up to the output, rtol + atol, and the amplification. The number of
/// steps is the largest of all runs, times the share of the time that has passed, and at least 1. With given
/// steps, every formulation also runs with half the step, and the bound is 2 (c_1 + c_2). Each formulation
/// has a change c: the largest relative change of lambda, up to the output, by half the step. c_1 and c_2 are
/// the largest and the second largest c; each counts as at least 5e-13, since lambda is rounded.
///
/// At one state: do all formulations give the same lambda and accelerations at the same positions and
/// velocities, within 100 u kappa? Here u is the unit roundoff of double and kappa the condition number of
/// Check::condition (trivium/solve.hpp).

#include <optional>
#include <string>
#include <vector>

#include "trivium/simulate.hpp"

namespace trivium {

/// What to compare. `run` holds the integrator, end time, tolerances and output step; its field
/// `at_step` is ignored, its `formulation` is checked and then ignored, and without `output_step` the run has
/// 100 output intervals.
struct CompareSettings {
  std::vector<std::string> formulations = {};  ///< at least two names; empty: all that the integrator accepts
  SimulateSettings run = {};                   ///< settings that all runs share
  /// Number of outputs, evenly spread, that are also compared at one state; at least 1. Above 500 unknowns (6
  /// nb + nc) fewer outputs are compared, above 6000 none.
  int states = 10;
};

/// The run of one formulation: its counters and warnings.
struct ComparedMotion {
  std::string formulation;            ///< name of the formulation
  std::string error;                  ///< why the run stopped before its end; empty if it did not
  std::vector<std::string> charts;    ///< names of all charts that bodies used at outputs, each once
  long steps = 0;                     ///< steps that were accepted
  long rejected_steps = 0;            ///< steps that were not accepted and tried again
  long right_sides = 0;               ///< evaluations of the equations of motion
  long newton_iterations = 0;         ///< iterations of Newton's method in implicit methods
  long factorisations = 0;            ///< factorisations of all matrices
  int chart_changes = 0;              ///< how often the chart of a body changed, all bodies together
  double seconds = 0;                 ///< CPU time of the thread for the run [s]
  std::vector<std::string> warnings;  ///< warnings about this run, as in Motion::warnings
};

/// All formulations at one output time. Every difference is the largest between any two formulations.
/// The difference of lambda is |E (lambda_1 - lambda_2)| / max(|E lambda_1|, |E lambda_2|, |E^-1 b|) over the
/// unique multipliers, with E^2 = diag(Phi_q M^-1 Phi_q^T) and b as in docs/lambda.md; differences of
/// accelerations are relative, in the metric of the mass matrix.
struct ComparedOutput {
  double t = 0;                  ///< time [s]
  double lambda_difference = 0;  ///< difference of lambda between the separate runs [-]
  double lambda_bound = 0;       ///< bound of lambda_difference [-]
  /// Largest relative change of lambda up to this output that a neighbouring start of the first formulation
  /// causes, divided by the distance of that start [-]; at least 1, and 1 with given steps. The distance is
  /// the largest of four differences: of positions relative to the length of the mechanism, of orientations
  /// [rad], of velocities and angular velocities relative to the largest ones.
  double amplification = 1;
  double position_difference = 0;  ///< distance of centres of mass [m]
  double rotation_difference = 0;  ///< 4 sin(theta / 4) [rad], nearly theta, the angle between orientations
  /// Whether lambda_difference is compared with its bound. False near a singular position, where lambda is
  /// not unique. Also false at the first output with one of the following properties, and at all later
  /// outputs: lambda of a neighbouring motion differs by more than 0.1, or the bound exceeds 0.1 (with given
  /// steps: 2 c_1 exceeds 0.1).
  bool is_judged = true;
  /// The comparison at one state. The runs of n formulations have n slightly different states at this output.
  /// At each of these states all n formulations are solved. The members belong to one of the n states: the
  /// one at which the largest ratio of a difference, of lambda or of accelerations, to its bound occurs.
  struct OneState {
    double lambda_difference = 0;  ///< relative difference of lambda [-]
    double lambda_bound = 0;       ///< bound of lambda_difference, 100 u kappa [-]
    /// Relative difference of accelerations [-]. It must not exceed lambda_bound either, unless the mechanism
    /// has no constraint rows.
    double acceleration_difference = 0;
    double condition = 1;  ///< kappa [-]
  };
  std::optional<OneState> one_state;  ///< only at the outputs that CompareSettings::states selects
};

/// The result of compare().
struct ComparedMotions {
  std::vector<ComparedMotion> motions;  ///< one per formulation
  std::vector<ComparedOutput> outputs;  ///< in time order; empty unless all runs are complete
  bool has_unique_lambda = true;        ///< false: no multiplier is unique, so no lambda can be compared
  bool complete = false;                ///< every formulation reached the end time
  bool holds_along = false;             ///< complete, and lambda is within its bound at every judged output
  /// Complete, and the one-state differences are within their bounds, except near singular positions.
  bool holds_at_states = false;
};

/// Runs all formulations and compares their motions. Throws an Error of kind input if the state violates its
/// constraints or if settings contradict each other, of kind model if the start cannot be analysed. An error
/// that stops the run of one formulation is stored in its ComparedMotion::error. An error of a run that only
/// measures a bound is thrown, of kind model or integration.
ComparedMotions compare(const Scene& scene, const CompareSettings& settings = {});

}  // namespace trivium
