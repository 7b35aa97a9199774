#pragma once
/// Steps of RATTLE that are chosen by a rule which is the same forwards and backwards in time. The energy
/// error of a symmetric method with such steps stays bounded, as with constant steps; it would grow with
/// steps that follow an error estimate of the last step. The rule is that of Hairer and Soederlind, SIAM
/// Journal on Scientific Computing 26 (2005). The density rho [1/s] of the steps follows the step Q(y) [s]
/// that meets the tolerances at a state:
///
///   rho_n+1/2 = rho_n-1/2 + G(y_n),   h_n+1/2 = 1 / rho_n+1/2,   G = -d ln Q / dt along the motion
///
/// Q makes the leading terms of the local error, h^3 v''/6 of positions and h^3 v'''/12 of velocities, as
/// large as the tolerances. The derivatives are differences of v' over the states at -2 d ... 2 d from the
/// present one. The spacing d stays the same until the next restart: it must not depend on the direction of
/// time.
///
/// A step that ends at a stop of the run (an event, the end) is shorter than the rule says, and a step that
/// cannot be solved is tried again with a quarter of its length. The rule begins anew after both. Outputs do
/// not limit steps: a step of its own leads from the start of the step to the time of an output.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "integrators/error_norm.hpp"
#include "integrators/step_size_control.hpp"
#include "integrators/symplectic/rattle.hpp"

namespace trivium::integrators {

template <HasNewtonMatrix System>
class ReversibleSteps {
 public:
  using S = typename System::Scalar;

  ReversibleSteps(Rattle<System> method, const Tolerances& tolerances)
      : method_(std::move(method)), tolerances_(tolerances) {}

  void step(System& system, S& t, StateVector<S>& y, const S& stop) {
    system_ = &system;
    if (!method_.has_begun()) {
      longest_ = stop - t;
      method_.begin(system, t, y, t + std::min(first_length(system, t, y), S(stop - t)));
      density_.reset();
    }
    choose(system, t, y);
    start_ = {t, y, method_.memory()};
    for (std::string trouble;;) {
      const S room = stop - t, h = 1 / *density_;
      if (!(h > 4 * std::numeric_limits<S>::epsilon() * std::max(absolute(t), absolute(stop))))
        give_up(system, t, y, trouble);
      // a rest below 1e-10 of a step comes from the rounding of t
      const bool lands = h >= room * S(1 - 1e-10);
      try {
        S time = t;
        method_.step(system, time, y, lands ? stop : S(t + h));
        require_finite(y, time);
        t = time;
        break;
      } catch (const UsageError&) {
        throw;
      } catch (const std::runtime_error& failure) {
        trouble = failure.what();
        y = start_.y;
        method_.recall(system, t, y, start_.memory);
        *density_ *= 4;
        ++rejected_;
      }
    }
    end_ = {t, y, method_.memory()};
    count();
  }
  void restart() {
    method_.restart();
    count();
  }
  /// Takes back the last step; the next one has a quarter of its length.
  bool shorten() {
    method_.recall(*system_, start_.t, start_.y, start_.memory);
    --taken_back_;
    ++rejected_;
    pending_ = 4 * *density_;
    count();
    return true;
  }
  const Counters& counters() const { return counters_; }
  const StateVector<S>* lambda() const { return method_.lambda(); }

  bool interpolates() const { return true; }
  /// A step from the start of the last step to t, or the end of the last step.
  void interpolate(const S& t, StateVector<S>& y) {
    if (t == end_.t) {
      y = end_.y;
      method_.recall(*system_, end_.t, end_.y, end_.memory);
      return;
    }
    y = start_.y;
    method_.recall(*system_, start_.t, start_.y, start_.memory);
    S time = start_.t;
    method_.step(*system_, time, y, t);
    --taken_back_;
    is_between_ = true;
    count();
  }

 private:
  struct Point {
    S t{0};
    StateVector<S> y;
    typename Rattle<System>::Memory memory;
  };
  /// v' at five states along the motion.
  using Accelerations = std::array<StateVector<S>, 5>;

  static S absolute(const S& x) { return x < S(0) ? S(-x) : x; }

  /// The length of a step that meets the tolerances at (t, y), before the spacing is known.
  S first_length(System& system, const S& t, const StateVector<S>& y) {
    spacing_ = first_step(system, t, y, 2, tolerances_, right_sides_);
    look(system, t, y);
    const S length = step_of(system, y, 1);
    spacing_ = length / 32;
    return length;
  }
  /// Chooses the density of the next step.
  void choose(System& system, const S& t, const StateVector<S>& y) {
    if (is_between_) {
      method_.recall(system, t, y, end_.memory);
      is_between_ = false;
    }
    look(system, t, y);
    using std::log;
    const S ahead = step_of(system, y, 2), behind = step_of(system, y, 0), now = step_of(system, y, 1);
    const S change = (log(behind) - log(ahead)) / (2 * spacing_);
    density_ = density_ ? S(*density_ + change) : S(1 / now + change / 2);
    // where Q changes by more than its size within a step, the rule could even give a negative density
    if (!(*density_ > 1 / (4 * now)) || !(*density_ < 4 / now)) density_ = 1 / now;
    if (pending_) density_ = std::exchange(pending_, std::nullopt);
  }
  /// v' at the states -2 d ... 2 d from (t, y).
  void look(System& system, const S& t, const StateVector<S>& y) {
    const int nq = system.position_size(), nv = system.velocity_size();
    v_ = y.segment(nq, nv);
    system.accelerations(t, y, v_dot_[2], lambda_);
    near_ = y;
    for (const int k : {0, 1, 3, 4}) {
      const S by = (k - 2) * spacing_;
      system.displace(y, by * v_ + by * by / 2 * v_dot_[2], near_);
      near_.segment(nq, nv) = v_ + by * v_dot_[2];
      system.accelerations(t + by, near_, v_dot_[k], lambda_);
    }
    right_sides_ += 5;
  }
  /// Q from the values k, k + 1 and k + 2 of v'.
  S step_of(System& system, const StateVector<S>& y, int k) {
    const int nq = system.position_size(), nv = system.velocity_size();
    of_q_ = (v_dot_[k + 2] - v_dot_[k]) / (12 * spacing_);
    of_v_ = (v_dot_[k + 2] - 2 * v_dot_[k + 1] + v_dot_[k]) / (12 * spacing_ * spacing_);
    system.position_sizes(y, sizes_);
    v_ = y.segment(nq, nv);
    const S error = in_tolerances<S>(tolerances_, sizes_, v_, v_, of_q_, of_v_);
    using std::pow;
    return pow(S(error + 1 / (longest_ * longest_ * longest_)), S(-1) / 3);
  }
  void count() {
    counters_ = method_.counters();
    counters_.steps += taken_back_;
    counters_.rejected_steps = rejected_;
    counters_.right_sides += right_sides_;
  }

  Rattle<System> method_;
  const Tolerances tolerances_;
  System* system_ = nullptr;
  S longest_{0};  ///< bound of a step where v' does not change [s]
  S spacing_{0};
  std::optional<S> density_, pending_;
  Point start_, end_;        ///< of the last step
  bool is_between_ = false;  ///< the method was last used for an output within the step
  Accelerations v_dot_;
  StateVector<S> v_, near_, of_q_, of_v_, sizes_, lambda_;
  long right_sides_ = 0, rejected_ = 0, taken_back_ = 0;
  Counters counters_;
};

}  // namespace trivium::integrators
