#include "validation/hard/exact_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/raise.hpp"
#include "bodies/numbers/quad.hpp"
#include "formulations/analysis/consistency.hpp"
#include "mechanism/reach.hpp"
#include "scenes/make_mechanism.hpp"
#include "simulation/neighbouring_start.hpp"
#include "simulation/simulate.hpp"

namespace trivium::hard {

namespace {

/// Far below the tolerances that are judged, and far above rounding.
constexpr double reference_tolerance = 1e-13, neighbour_tolerance = 1e-12;
/// Runs in quad take longer. Of neighbours, all runs together.
constexpr long most_steps_in_quad = 300'000, most_steps_of_neighbours = 20'000'000;

/// The states of a run after its start, up to its end or its trouble.
struct Reference {
  std::vector<MechanismState<double>> states;
  std::string trouble;  ///< why it ends early; empty if it does not
  bool is_given_up = false;
  long steps = 0;
};

template <class Scalar>
Reference run(const Model<Scalar>& model, const SimulationOptions& options, long most) {
  Reference found;
  LimitedSamples samples(most);
  try {
    const SimulationReport report = simulate(model, options, samples);
    found.steps = report.counters.steps;
    found.is_given_up = !report.complete;
    if (found.is_given_up) found.trouble = fmt::format("given up after {} steps", most);
  } catch (const Error& error) {
    found.trouble = error.what();
  }
  for (std::size_t k = 1; k < samples.all.size(); ++k) found.states.push_back(samples.all[k].state);
  return found;
}

}  // namespace

ExactMotion::ExactMotion(const HardMotion& motion)
    : motion_(motion), output_step_((motion.end - motion.start) / hard_outputs) {
  const auto model = make_model<double>(motion.scene, motion.start);
  if (motion.exact) {
    for (int k = 1; k <= hard_outputs; ++k) {
      MechanismState<double> state = model.state;
      state.t = motion.start + k * output_step_;
      motion.exact(state);
      states_.push_back(state);
    }
  } else {
    const bool in_quad = motion.reference == ReferenceRun::in_quad;
    const double rtol = in_quad ? 1e-16 : reference_tolerance;
    Reference found =
        in_quad ? run(make_model<Quad>(motion.scene, Quad(motion.start)), options(rtol), most_steps_in_quad)
                : run(model, options(rtol), most_steps);
    states_ = std::move(found.states);
    trouble_ = std::move(found.trouble);
    is_given_up_ = found.is_given_up;
    tolerance_ = static_cast<double>(found.steps) * HardMotion::of_a_step(rtol);
  }
  reach_ = reaches(model.mechanism);
  length_ = motion.length;
  if (!(length_ > 0)) {
    length_ = extent_of(model.mechanism, model.state).length;
    for (const auto& state : states_) raise(length_, extent_of(model.mechanism, state).length);
  }
  if (!(length_ > 0)) length_ = 1;
  for (const auto& state : states_)
    for (const Twist<double>& twist : state.twist) {
      raise(speed_, twist.r_dot.norm());
      raise(rate_, twist.omega_bar.norm());
    }
  // a mechanism at rest: its length within the run
  if (!(speed_ > 0)) speed_ = length_ / (motion.end - motion.start);
  if (!(rate_ > 0)) rate_ = speed_ / length_;
  if (trouble_.empty())
    measure_amplification(model);
  else
    states_.clear();
}

SimulationOptions ExactMotion::options(double rtol) const {
  SimulationOptions options;
  options.integrator = motion_.reference == ReferenceRun::stiff ? "radau9" : "rkf78";
  options.end = motion_.end;
  options.output_step = output_step_;
  options.tolerances = motion_.tolerances(rtol);
  options.max_step = motion_.max_step;
  return options;
}

double ExactMotion::difference(const MechanismState<double>& a, const MechanismState<double>& b) const {
  double largest = 0;
  for (std::size_t n = 0; n < a.pose.size(); ++n) {
    raise(largest, (a.pose[n].r - b.pose[n].r).norm() / length_);
    if (motion_.monitor == Monitor::positions) continue;
    raise(largest, turn_between(a.pose[n].p, b.pose[n].p));
    raise(largest, (a.twist[n].r_dot - b.twist[n].r_dot).norm() / speed_);
    raise(largest, (a.twist[n].omega_bar - b.twist[n].omega_bar).norm() / rate_);
  }
  return largest;
}

double ExactMotion::difference(const MechanismState<double>& state, std::size_t k) const {
  return difference(state, states_[k]);
}

double ExactMotion::difference(const LocalErrorSums& errors) const {
  double largest = std::max(errors.relative(), errors.position / length_);
  if (motion_.monitor == Monitor::positions) return largest;
  raise(largest, errors.velocity / speed_);
  if (const double reach = reach_[errors.body]; reach > 0) {
    raise(largest, errors.position / reach);
    raise(largest, errors.velocity / (reach * rate_));
  }
  return largest;
}

double ExactMotion::distance() const {
  double farthest = 0;
  for (const auto& state : states_)
    for (const Pose<double>& pose : state.pose) raise(farthest, pose.r.norm());
  return farthest / length_;
}

double ExactMotion::of_velocities(double positions, double step) const {
  if (motion_.monitor == Monitor::positions) return 0;
  return positions * std::max(length_ / speed_, 1 / rate_) / step;
}

void ExactMotion::measure_amplification(const Model<double>& model) {
  amplification_.assign(states_.size(), 1);
  // steps err all along the motion: neighbours start at its start and after outputs
  const std::size_t every = hard_outputs / motion_.starts;
  long steps_left = most_steps_of_neighbours;
  bool is_whole = true;
  const auto run_from = [&](const Model<double>& from) {
    const Reference found = run(from, options(neighbour_tolerance), steps_left);
    steps_left = std::max(1L, steps_left - found.steps);
    is_whole = is_whole && !found.is_given_up;
    return found.states;
  };
  for (std::size_t first = 0; first < states_.size(); first += every) {
    Model<double> from = model;
    if (first > 0) from.state = states_[first - 1];
    // neighbours are compared with a run of their own kind, so that its errors cancel; a run that does not
    // get through says nothing about the exact motion
    const std::vector<MechanismState<double>> itself = run_from(from);
    for (int d = 0; d < motion_.directions; ++d) {
      const int seed = 1 + static_cast<int>(first) * motion_.directions + d;
      NeighbouringStart start;
      try {
        start = neighbouring_start(from, neighbour_tolerance, seed, 1e4);
      } catch (const Error&) {  // no neighbour satisfies the constraints in double, or none can be found
        continue;
      }
      if (!(start.distance > 0)) {  // the constraints leave no neighbour
        has_neighbours_ = true;
        return;
      }
      Model<double> near = from;
      near.state = start.state;
      // its distance is relative to the whole mechanism
      const double whole = extent_of(from.mechanism, from.state).length,
                   apart = start.distance * std::max(1.0, whole / length_);
      const std::vector<MechanismState<double>> states = run_from(near);
      double largest = 1;
      for (std::size_t k = 0; k < std::min(states.size(), itself.size()); ++k) {
        raise(largest, difference(itself[k], states[k]) / apart);
        raise(amplification_[first + k], largest);
        has_neighbours_ = true;
      }
    }
  }
  has_neighbours_ = has_neighbours_ && is_whole;
}

}  // namespace trivium::hard
