#pragma once
/// What implicit methods need beside a state to begin from there, and the work that they add up.

#include <utility>

#include "integrators/contract/constrained_system.hpp"
#include "integrators/contract/method.hpp"

namespace trivium::integrators {

/// v' and lambda of index 1 at a state, and how fast they change along the motion, to second order of a
/// fraction of the step ahead: what is behind may be another branch.
template <class S>
struct Start {
  StateVector<S> v_dot, lambda, v_ddot, lambda_dot;
  S work_rate{0};

  template <ConstrainedSystem System>
  Start(System& system, const S& t, const StateVector<S>& y, const S& h, Counters& counters) {
    const int nq = system.position_size(), nv = system.velocity_size();
    const StateVector<S> v = y.segment(nq, nv);
    if (y.size() > nq + nv) {
      StateVector<S> y_dot;
      system.derivative(t, y, y_dot);
      work_rate = y_dot[nq + nv];
    }
    system.accelerations(t, y, v_dot, lambda);
    StateVector<S> v_dot_at[2], lambda_at[2], ahead = y;
    const S s = h / 16;
    for (int k = 0; k < 2; ++k) {
      const S by = (k + 1) * s;
      system.displace(y, by * v + by * by / 2 * v_dot, ahead);
      ahead.segment(nq, nv) = v + by * v_dot;
      system.accelerations(t + by, ahead, v_dot_at[k], lambda_at[k]);
    }
    counters.right_sides += 3;
    const auto slope = [&](const StateVector<S>& at, const StateVector<S>& next, const StateVector<S>& last) {
      return StateVector<S>((4 * next - 3 * at - last) / (2 * s));
    };
    v_ddot = slope(v_dot, v_dot_at[0], v_dot_at[1]);
    lambda_dot = slope(lambda, lambda_at[0], lambda_at[1]);
  }
};

/// A quantity at the ends of the last two steps, and on along the line through them.
template <class S>
class Line {
 public:
  void begin(const StateVector<S>& value, const StateVector<S>& rate, const S& h) {
    now_ = value;
    before_ = value - h * rate;
  }
  const StateVector<S>& now() const { return now_; }
  /// So many of the last step's lengths ahead.
  StateVector<S> ahead(const S& steps) const { return now_ + steps * (now_ - before_); }
  void push(StateVector<S> value) { before_ = std::exchange(now_, std::move(value)); }

 private:
  StateVector<S> now_, before_;
};

/// The work behind q and v in y, where a system has it: by trapezoids, of order 2.
template <class S>
class WorkByTrapezoids {
 public:
  void begin(const S& rate) { rate_ = rate; }
  /// Over a step of h to where the system was evaluated last.
  template <ConstrainedSystem System>
  void add(System& system, const StateVector<S>& lambda, const S& h, StateVector<S>& y) {
    const int motion = system.position_size() + system.velocity_size();
    if (y.size() > motion) add(S(system.work_rate(lambda)), h, y[motion]);
  }
  /// Over a step of h to where this is its rate.
  void add(const S& rate, const S& h, S& work) {
    const S before = std::exchange(rate_, rate);
    work += h * (before + rate_) / 2;
  }

 private:
  S rate_{0};
};

}  // namespace trivium::integrators
