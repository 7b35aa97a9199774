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
#include "simulation/system/motion_log.hpp"

namespace trivium {

/// What a run shows at an output, in double whatever it computes in; and of runs beyond double, what that
/// leaves of a state and of lambda.
struct MotionSample {
  MechanismState<double> state;
  std::vector<Reaction<double>> reactions;  ///< on body j of every joint: global, about its point on i
  VectorX<double>
      lambda;  ///< of (q, v); where rows are dependent those of least |E lambda|, where they can be had
  VectorX<double> raw_lambda;   ///< the method's own; empty where it has none
  double energy = 0;            ///< kinetic and potential [J]
  double phi = 0, phi_dot = 0;  ///< largest violation of any row, m or rad (per second)
  std::optional<MechanismState<double>> state_rest = {};
  VectorX<double> lambda_rest = {}, raw_lambda_rest = {};
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
};

/// Sees a run go by. `step` is asked after every step whether to go on.
class SimulationObserver {
 public:
  virtual ~SimulationObserver() = default;
  virtual void sample(const MotionSample&) {}
  virtual bool step(double /*t*/) { return true; }
};

/// Keeps what it sees.
class Samples : public SimulationObserver {
 public:
  void sample(const MotionSample& s) override { all.push_back(s); }
  std::vector<MotionSample> all;
};

}  // namespace trivium
