#pragma once
/// Backward differentiation formulas of orders 1 to 5 on index 3, at constant steps:
///
///   q_n+1 = sum c_j q_n-j + b h q'_n+1,   v_n+1 = sum c_j v_n-j + b h v'_n+1
///   M v'_n+1 + Phi_q^T lambda_n+1 = Q,    Phi(q_n+1, t_n+1) = 0
///
/// On a Lie group q counts as the displacement theta from q_n, with the rate T(theta)^-1 v: the formula is
/// that of a chart about q_n, and keeps its order. The first steps, and those after a restart, are Radau's:
/// of order 5 as none here is above, and stiff ones are no shorter.

#include <array>
#include <cmath>
#include <deque>

#include "integrators/implicit/newton.hpp"
#include "integrators/implicit/radau.hpp"
#include "integrators/time_grid.hpp"

namespace trivium::integrators {

/// In whole numbers: y_n+1 = (sum c[j] y_n-j + b h y'_n+1) / divisor.
struct BackwardFormula {
  int divisor, b;
  std::array<int, 5> c;

  static BackwardFormula of_order(int order) {
    static constexpr std::array<BackwardFormula, 5> all{{{1, 1, {1}},
                                                         {3, 2, {4, -1}},
                                                         {11, 6, {18, -9, 2}},
                                                         {25, 12, {48, -36, 16, -3}},
                                                         {137, 60, {300, -300, 200, -75, 12}}}};
    return all.at(order - 1);
  }
};

template <HasSprings System>
requires HasInternalRows<System>
class BDF {
 public:
  using S = typename System::Scalar;

  /// Of order 1 to 5.
  BDF(int order, const NewtonOptions& newton)
      : order_(order), formula_(BackwardFormula::of_order(order)), newton_(newton), start_({}, newton) {}

  void step(System& system, S& t, StateVector<S>& y, const S& stop) {
    const S h = stop - t;
    if (!is_same_length(h, h_)) forget();
    h_ = h;
    if (past_.empty()) remember(system, t, y);
    if (static_cast<int>(past_.size()) < order_) {
      start(system, t, y, stop);
      remember(system, t, y);
    } else {
      advance(system, stop, y);
      t = stop;
    }
    ++counters_.steps;
  }
  void restart() {
    forget();
    ++counters_.restarts;
  }
  bool shorten() { return false; }
  const Counters& counters() const { return counters_; }
  const StateVector<S>* lambda() const { return past_.empty() ? nullptr : &past_.front().lambda; }

 private:
  struct Point {
    StateVector<S> y, v_dot, lambda;
  };

  void forget() {
    past_.clear();
    start_.restart();
  }
  /// A state that index 1 tells all of.
  void remember(System& system, const S& t, const StateVector<S>& y) {
    Point point{y, {}, {}};
    system.accelerations(t, y, point.v_dot, point.lambda);
    ++counters_.right_sides;
    push(std::move(point));
  }
  void push(Point point) {
    past_.push_front(std::move(point));
    if (static_cast<int>(past_.size()) > order_) past_.pop_back();
  }

  void start(System& system, S& t, StateVector<S>& y, const S& stop) {
    const Counters before = start_.counters();
    start_.step(system, t, y, stop);
    counters_.right_sides += start_.counters().right_sides - before.right_sides;
    counters_.iterations += start_.counters().iterations - before.iterations;
  }

  void advance(System& system, const S& t, StateVector<S>& y) {
    const int nq = system.position_size(), nv = system.velocity_size();
    const S b = S(formula_.b) * h_ / formula_.divisor;
    // what is known of theta, v and the work: theta about q_n
    StateVector<S> theta_known = StateVector<S>::Zero(nv), known = StateVector<S>::Zero(y.size() - nq);
    for (int j = 0; j < order_; ++j) {
      const S c = S(formula_.c[j]) / formula_.divisor;
      known += c * past_[j].y.tail(y.size() - nq);
      if (j == 0) continue;
      system.displacement(past_[0].y, past_[j].y, theta_);
      theta_known += c * theta_;
    }
    const StateVector<S> v_known = known.head(nv);
    const auto place = [&](const StepUnknowns<S>& x, StateVector<S>& to) {
      v_ = v_known + b * x.v_dot;
      displace(system, theta_known, b);
      system.displace(past_[0].y, theta_, to);
      to.segment(nq, nv) = v_;
    };
    StepUnknowns<S> x{predicted(&Point::v_dot), predicted(&Point::lambda), {}};
    newton_(system, t, {b * b, b}, place, y, x, counters_);
    if (y.size() > nq + nv) y[nq + nv] = known[nv] + b * system.work_rate(newton_.at(), x.lambda);
    push({y, x.v_dot, x.lambda});
  }
  /// theta = theta_known + b rate(theta, v), by iteration: what a body turns in a step is a small angle.
  void displace(System& system, const StateVector<S>& theta_known, const S& b) {
    theta_ = theta_known + b * v_;
    S before = std::numeric_limits<S>::max();
    for (int k = 0; k < 50; ++k) {
      system.displacement_rate(theta_, v_, rate_);
      const StateVector<S> next = theta_known + b * rate_;
      const S moved = (next - theta_).norm();
      theta_ = next;
      if (moved == S(0) || !(moved < before)) return;
      before = moved;
    }
  }
  /// On from the points remembered, by the polynomial through them.
  StateVector<S> predicted(StateVector<S> Point::*of) const {
    StateVector<S> sum = StateVector<S>::Zero((past_[0].*of).size());
    const int n = static_cast<int>(past_.size());
    S weight(1);
    for (int j = 0; j < n; ++j) {
      weight *= S(n - j) / (j + 1);  // the binomial n over j + 1
      sum += (j % 2 == 0 ? weight : S(-weight)) * (past_[j].*of);
    }
    return sum;
  }

  const int order_;
  const BackwardFormula formula_;
  Newton<System> newton_;
  Radau5<System> start_;
  std::deque<Point> past_;  ///< the latest first
  S h_{0};
  StateVector<S> theta_, rate_, v_;
  Counters counters_;
};

}  // namespace trivium::integrators
