#pragma once
/// Backward differentiation formulas of orders 1 to 5 on index 3, at constant steps:
///
///   q_n+1 = sum c_j q_n-j + b h q'_n+1,   v_n+1 = sum c_j v_n-j + b h v'_n+1
///   M v'_n+1 + Phi_q^T lambda_n+1 = Q,    Phi(q_n+1, t_n+1) = 0
///
/// On a Lie group the formula is applied to the displacement theta from q_n, whose rate is T(theta)^-1 v
/// (displacement_rate of the system): this is the formula in a chart about q_n, so that its order holds. The
/// first steps, and those after a restart, are taken by Radau IIA: its order 5 is no lower than any order
/// here, and it needs no shorter steps where springs are stiff.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "integrators/implicit/newton.hpp"
#include "integrators/implicit/radau.hpp"
#include "integrators/time_grid.hpp"

namespace trivium::integrators {

/// A formula in whole numbers: y_n+1 = (sum c[j] y_n-j + b h y'_n+1) / divisor.
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

  /// The order is 1 to 5.
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
  /// Remembers a state, with v' and lambda solved from it by the equations of index 1.
  void remember(System& system, const S& t, const StateVector<S>& y) {
    system.accelerations(t, y, x_.v_dot, x_.lambda);
    ++counters_.right_sides;
    push(y, x_.v_dot, x_.lambda);
  }
  /// Puts a state in front. It takes the place of the oldest one if there are as many as the order.
  void push(const StateVector<S>& y, const StateVector<S>& v_dot, const StateVector<S>& lambda) {
    if (static_cast<int>(past_.size()) < order_) past_.emplace_back();
    std::rotate(past_.begin(), past_.end() - 1, past_.end());
    past_.front().y = y;
    past_.front().v_dot = v_dot;
    past_.front().lambda = lambda;
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
    // the known part of the formulas for theta (the displacement from q_n), v and the work
    theta_known_.setZero(nv);
    known_.setZero(y.size() - nq);
    for (int j = 0; j < order_; ++j) {
      const S c = S(formula_.c[j]) / formula_.divisor;
      known_ += c * past_[j].y.tail(y.size() - nq);
      if (j == 0) continue;
      system.displacement(past_[0].y, past_[j].y, theta_);
      theta_known_ += c * theta_;
    }
    const auto place = [&](const StepUnknowns<S>& x, StateVector<S>& to) {
      v_ = known_.head(nv) + b * x.v_dot;
      displace(system, b);
      system.displace(past_[0].y, theta_, to);
      to.segment(nq, nv) = v_;
    };
    predict(&Point::v_dot, x_.v_dot);
    predict(&Point::lambda, x_.lambda);
    newton_(system, t, {b * b, b}, place, y, x_, counters_);
    if (y.size() > nq + nv) y[nq + nv] = known_[nv] + b * system.work_rate(newton_.at(), x_.lambda);
    push(y, x_.v_dot, x_.lambda);
  }
  /// Solves theta = theta_known + b rate(theta, v) by fixed-point iteration. An iteration multiplies the
  /// error by about the angle [rad] by which bodies rotate in the step; 50 is a safety limit.
  void displace(System& system, const S& b) {
    theta_ = theta_known_ + b * v_;
    S before = std::numeric_limits<S>::max();
    for (int k = 0; k < 50; ++k) {
      system.displacement_rate(theta_, v_, rate_);
      next_ = theta_known_ + b * rate_;
      const S moved = (next_ - theta_).norm();
      theta_.swap(next_);
      if (moved == S(0) || !(moved < before)) return;
      before = moved;
    }
  }
  /// Extrapolates to the next step by the polynomial through the remembered states.
  void predict(StateVector<S> Point::*of, StateVector<S>& sum) const {
    sum.setZero((past_[0].*of).size());
    const int n = static_cast<int>(past_.size());
    S weight(1);
    for (int j = 0; j < n; ++j) {
      weight *= S(n - j) / (j + 1);  // binomial coefficient: n over j + 1
      sum += (j % 2 == 0 ? weight : S(-weight)) * (past_[j].*of);
    }
  }

  const int order_;
  const BackwardFormula formula_;
  Newton<System> newton_;
  Radau5<System> start_;
  std::vector<Point> past_;  ///< the latest first
  S h_{0};
  StateVector<S> theta_, theta_known_, known_, rate_, next_, v_;
  StepUnknowns<S> x_;
  Counters counters_;
};

}  // namespace trivium::integrators
