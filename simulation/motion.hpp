#pragma once
/// A motion as a run shows it: a sample at every output, a report at the end, and the observer that sees both
/// go by. Plain data in double, whatever formulation, Scalar and method the run had.

#include <optional>
#include <string>
#include <vector>

#include "bodies/reaction.hpp"
#include "integrators/contract/method.hpp"
#include "integrators/projection_report.hpp"
#include "mechanism/mechanism_state.hpp"
#include "mechanism/saved_run.hpp"
#include "simulation/system/motion_log.hpp"

namespace trivium {

/// What a run shows at an output, in double whatever it computes in; and of runs beyond double, what that
/// leaves of a state and of lambda.
struct MotionSample {
  MechanismState<double> state;
  std::vector<Vector3<double>> r_ddot, omega_bar_dot;  ///< per body; global, body frame
  std::vector<Reaction<double>> reactions;  ///< on body j of every joint: global, about its point on i
  VectorX<double>
      lambda;  ///< of (q, v); where rows are dependent those of least |E lambda|, where they can be had
  std::vector<bool> lambda_unique;  ///< per row
  /// What the last refinement corrected of lambda and of accelerations, relative: an estimate of their
  /// errors.
  double lambda_error = 0, acceleration_error = 0;
  VectorX<double> raw_lambda;       ///< the method's own; empty where it has none
  double energy = 0;                ///< kinetic and potential [J]
  double phi = 0, phi_dot = 0;      ///< largest violation of any row, m or rad (per second)
  std::vector<std::string> charts;  ///< per body; empty for formulations without
  std::vector<double> angles;       ///< where joint angles were counted last [rad], effect by effect
  std::optional<MechanismState<double>> state_rest = {};
  VectorX<double> lambda_rest = {}, raw_lambda_rest = {};
};

/// Where a run stands when it ends, for another to go on from.
struct RunEnd {
  MechanismState<double> state;
  std::vector<int> turns;  ///< of every joint angle that effects count, by its effect, in their order
  SavedRun run;
};

struct SimulationReport {
  double reached = 0;
  double seconds = 0;     ///< of this thread's CPU, from the first state to the last
  bool complete = false;  ///< not stopped from outside
  integrators::Counters counters;
  long factorisations = 0, jacobians = 0;  ///< of all matrices; Newton's, each made anew
  bool is_projected = true, is_implicit = false, has_own_lambda = false;
  double lambda_gap = 0;  ///< of methods with their own: largest |raw lambda - lambda| of a row at an output
  integrators::ProjectionReport<double> projection;
  int reframings = 0;
  double phi = 0, phi_dot = 0;              ///< largest after any step
  double normalisation = 0;                 ///< largest |p . p - 1| after any step
  double energy_start = 0, energy_end = 0;  ///< kinetic and potential [J]
  bool does_work = false;
  double work = 0;                ///< of drivers, and of effects as far as it is not stored [J]
  double unaccounted_energy = 0;  ///< largest change of energy that this work does not account for [J]
  double largest_kinetic = 0;     ///< what that is large beside [J]
  std::vector<SingularPassage> passages;
  std::string near_singular_chart;  ///< where charts are kept: the first body that came near one, and when
  std::vector<Impulse<double>> impulses;
  RunEnd end;
};

/// Sees a run go by, and is asked after every step and at every output whether to go on. Where it is not at
/// an output between two steps, the run goes to the end of the step.
class SimulationObserver {
 public:
  virtual ~SimulationObserver() = default;
  virtual bool sample(const MotionSample&) { return true; }
  virtual bool step(double /*t*/) { return true; }
};

/// Keeps what it sees.
class Samples : public SimulationObserver {
 public:
  bool sample(const MotionSample& s) override {
    all.push_back(s);
    return true;
  }
  std::vector<MotionSample> all;
};

}  // namespace trivium
