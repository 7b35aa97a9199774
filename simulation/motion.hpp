#pragma once
/// The results of a run: a sample at every output, a report at the end, and the interface of the observer
/// that receives the samples. All numbers are double, whatever formulation, Scalar and method the run uses.

#include <optional>
#include <string>
#include <vector>

#include "bodies/reaction.hpp"
#include "integrators/contract/method.hpp"
#include "integrators/projection_report.hpp"
#include "mechanism/mechanism_state.hpp"
#include "mechanism/saved_run.hpp"
#include "simulation/system/error_sums.hpp"
#include "simulation/system/motion_log.hpp"

namespace trivium {

/// The state of a run at an output, rounded to double. In runs with more digits than double, the `_rest`
/// members hold the rounding errors, so that value + rest has about twice the digits.
struct MotionSample {
  MechanismState<double> state;
  /// Per body: r'' [m/s^2] in the global frame, omega_bar' [rad/s^2] in the body frame.
  std::vector<Vector3<double>> r_ddot, omega_bar_dot;
  std::vector<Reaction<double>> reactions;  ///< per joint, on body j: global frame, about its point on i
  /// Multipliers solved from (q, v) [J divided by the unit of the row]. With dependent rows they are those of
  /// the least |E lambda|, if these exist, else 0 in dependent rows (motion_watch.hpp).
  VectorX<double> lambda;
  std::vector<bool> lambda_unique;  ///< per row
  /// Estimated relative errors of lambda and accelerations: the corrections by the last refinement step.
  double lambda_error = 0, acceleration_error = 0;
  /// Multipliers of the method itself, in the units of lambda. Empty if the method has none, and where it has
  /// computed none yet: at the start, and after a restart. CSV files then contain lambda.
  VectorX<double> raw_lambda;
  double energy = 0;                ///< kinetic plus potential [J]
  double phi = 0, phi_dot = 0;      ///< largest violation of any row [m or rad, m/s or rad/s]
  std::vector<std::string> charts;  ///< per body; empty for formulations without charts
  std::vector<double> angles;       ///< joint angles that effects counted last [rad], in their order
  /// The rounding errors of state, lambda and raw_lambda.
  std::optional<MechanismState<double>> state_rest = {};
  VectorX<double> lambda_rest = {}, raw_lambda_rest = {};
};

/// The end of a run, from which another run can continue.
struct RunEnd {
  MechanismState<double> state;
  std::vector<int> turns;  ///< full turns of the joint angles that effects count, in the effects' order
  SavedRun run;            ///< state vector and memory of the method
};

/// The report on a run: how far it came, its work, and its errors.
struct SimulationReport {
  double reached = 0;     ///< time reached [s]
  double seconds = 0;     ///< CPU time of this thread between the first and the last state [s]
  bool complete = false;  ///< the end was reached; the observer did not stop the run
  integrators::Counters counters;
  long factorisations = 0, jacobians = 0;  ///< of all matrices; of Newton matrices alone
  /// Whether states are projected after every step. Whether the method satisfies Phi = 0 by its own
  /// equations. Whether the method computes multipliers of its own.
  bool is_projected = true, is_implicit = false, has_raw_lambda = false;
  double lambda_gap = 0;  ///< largest |raw_lambda - lambda of the acceleration solver| of a row at an output
  integrators::ProjectionReport<double> projection;
  int reframings = 0;                       ///< changes of the chart of a body
  double phi = 0, phi_dot = 0;              ///< largest violation after any step [m or rad, m/s or rad/s]
  double normalisation = 0;                 ///< largest |p . p - 1| after any step [-]
  double energy_start = 0, energy_end = 0;  ///< kinetic plus potential [J]
  bool does_work = false;                   ///< a driver or a non-conservative effect may do work
  double work = 0;                          ///< work of drivers and of non-conservative effects [J]
  double unaccounted_energy = 0;            ///< largest |change of energy - work| after any step [J]
  /// Sums of the errors of single steps, for methods with given steps.
  std::optional<LocalErrorSums> local_errors = {};
  std::string errs_most = {};  ///< name of the body of local_errors
  /// Sum of m v^2 / 2 over the bodies, v the fastest speed so far in the body's group of connected bodies
  /// [J].
  double fastest_energy = 0;
  double largest_kinetic = 0;             ///< largest kinetic energy, to compare unaccounted_energy with [J]
  std::vector<SingularPassage> passages;  ///< singular positions that the motion passed, in time order
  std::vector<std::string> narrow_rows;   ///< warnings of rows near the rank tolerance at the start
  std::string near_singular_chart;  ///< if charts are kept: the first body near a singularity, and the time
  std::vector<Impulse<double>> impulses;  ///< jumps of velocities by kinks of drivers, in time order
  RunEnd end;
};

/// Receives every output (sample) and every step of a run; a result false stops the run. If an output lies
/// inside a step and stops the run, the run still ends at the end of that step.
class SimulationObserver {
 public:
  virtual ~SimulationObserver() = default;
  virtual bool sample(const MotionSample&) { return true; }
  virtual bool step(double /*t*/) { return true; }
};

/// An observer that keeps all samples.
class Samples : public SimulationObserver {
 public:
  bool sample(const MotionSample& s) override {
    all.push_back(s);
    return true;
  }
  std::vector<MotionSample> all;
};

}  // namespace trivium
