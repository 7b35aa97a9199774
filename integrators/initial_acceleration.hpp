#pragma once
/// The start values of implicit methods at a given state: accelerations, multipliers and the rates of both.
/// The rates are differences of second order over two states slightly ahead in time.

#include "integrators/contract/method.hpp"
#include "integrators/contract/residual.hpp"

namespace trivium::integrators {

/// v' and lambda at a state, solved from the equations of index 1 (constraints differentiated twice), and
/// their rates along the motion. The rates are one-sided differences over the states at h / 16 and h / 8
/// after the start, since the start may be an event, before which functions of time have another piece. These
/// fractions of the step size h keep the truncation error small and are large compared with rounding.
/// `work_rate` is the rate of the work [W], 0 in a system without work.
template <class S>
struct InitialAcceleration {
  StateVector<S> v_dot, lambda, v_ddot, lambda_dot;
  S work_rate{0};

  template <HasResidual System>
  InitialAcceleration(System& system, const S& t, const StateVector<S>& y, const S& h, Counters& counters) {
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

}  // namespace trivium::integrators
