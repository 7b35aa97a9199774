#include "validation/hard/exact_motion.hpp"

#include <algorithm>

#include "base/raise.hpp"
#include "bodies/numbers/quad.hpp"
#include "formulations/analysis/consistency.hpp"
#include "scenes/make_mechanism.hpp"
#include "simulation/neighbouring_start.hpp"
#include "simulation/simulate.hpp"

namespace trivium::hard {

namespace {

/// Far below the tolerances that are judged, and far above rounding.
constexpr double reference_tolerance = 1e-13, neighbour_tolerance = 1e-12;

/// The states of a run after its start.
template <class Scalar>
std::vector<MechanismState<double>> states_of(const Model<Scalar>& model, const SimulationOptions& options) {
  Samples samples;
  simulate(model, options, samples);
  std::vector<MechanismState<double>> states;
  for (std::size_t k = 1; k < samples.all.size(); ++k) states.push_back(samples.all[k].state);
  return states;
}

}  // namespace

ExactMotion::ExactMotion(const scenes::Scene& scene, double end, int outputs, Monitor monitor,
                         const ExactState& exact, ReferenceRun reference)
    : end_(end), output_step_(end / outputs), monitor_(monitor), reference_(reference) {
  const auto model = make_model<double>(scene);
  if (exact) {
    for (int k = 1; k <= outputs; ++k) {
      MechanismState<double> state = model.state;
      state.t = k * output_step_;
      exact(state);
      states_.push_back(state);
    }
  } else if (reference == ReferenceRun::in_quad) {
    states_ = states_of(make_model<Quad>(scene), options(1e-16));
  } else {
    states_ = states_of(model, options(reference_tolerance));
  }
  if (const double length = extent_of(model.mechanism, model.state).length; length > 0) length_ = length;
  double speed = 0, rate = 0;
  for (const auto& state : states_)
    for (const Twist<double>& twist : state.twist) {
      raise(speed, twist.r_dot.norm());
      raise(rate, twist.omega_bar.norm());
    }
  // a mechanism at rest: its length within the run
  speed_ = speed > 0 ? speed : length_ / end;
  rate_ = rate > 0 ? rate : 1 / end;
  measure_amplification(model);
}

SimulationOptions ExactMotion::options(double rtol) const {
  SimulationOptions options;
  options.integrator = reference_ == ReferenceRun::stiff ? "radau9" : "rkf78";
  options.end = end_;
  options.output_step = output_step_;
  options.tolerances = {rtol, rtol / 100};
  return options;
}

double ExactMotion::difference(const MechanismState<double>& a, const MechanismState<double>& b) const {
  double largest = 0;
  for (std::size_t n = 0; n < a.pose.size(); ++n) {
    raise(largest, (a.pose[n].r - b.pose[n].r).norm() / length_);
    if (monitor_ == Monitor::positions) continue;
    raise(largest, turn_between(a.pose[n].p, b.pose[n].p));
    raise(largest, (a.twist[n].r_dot - b.twist[n].r_dot).norm() / speed_);
    raise(largest, (a.twist[n].omega_bar - b.twist[n].omega_bar).norm() / rate_);
  }
  return largest;
}

double ExactMotion::difference(const MechanismState<double>& state, std::size_t k) const {
  return difference(state, states_[k]);
}

void ExactMotion::measure_amplification(const Model<double>& model) {
  amplification_.assign(states_.size(), 1);
  // neighbours are compared with a run of their own kind, so that its errors cancel
  const std::vector<MechanismState<double>> itself = states_of(model, options(neighbour_tolerance));
  for (int seed = 1; seed <= neighbours; ++seed) {
    const NeighbouringStart start = neighbouring_start(model, neighbour_tolerance, seed, 1e4);
    if (!(start.distance > 0)) return;  // the constraints leave no neighbour
    Model<double> near = model;
    near.state = start.state;
    const std::vector<MechanismState<double>> states = states_of(near, options(neighbour_tolerance));
    double largest = 1;
    for (std::size_t k = 0; k < states_.size(); ++k) {
      raise(largest, difference(itself[k], states[k]) / start.distance);
      raise(amplification_[k], largest);
    }
  }
}

}  // namespace trivium::hard
