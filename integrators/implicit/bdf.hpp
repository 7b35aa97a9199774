#pragma once
/// Backward differentiation formulas of orders 1 to 5 on index 3:
///
///   q_n+1 = sum c_j q_n-j + b q'_n+1,   v_n+1 = sum c_j v_n-j + b v'_n+1
///   M v'_n+1 + Phi_q^T lambda_n+1 = Q,    Phi(q_n+1, t_n+1) = 0
///
/// On a Lie group the formula is applied to the displacement theta from q_n, whose rate is T(theta)^-1 v
/// (displacement_rate of the system): this is the formula in a chart about q_n, so that its order holds. The
/// first steps, and those after a restart, are taken by Radau IIA: its order 5 is no lower than any order
/// here, and it needs no shorter steps where springs are stiff.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "integrators/implicit/newton.hpp"
#include "integrators/implicit/radau.hpp"
#include "integrators/lagrange.hpp"
#include "integrators/time_grid.hpp"

namespace trivium::integrators {

/// The formula y_n+1 = sum c[j] y_n-j + b y'_n+1.
template <class S>
struct BackwardFormula {
  S b;
  std::array<S, 5> c;

  /// `times` are those of y_n+1 and of the values before it; their unit is that of b.
  explicit BackwardFormula(const PolynomialNumbers<S>& times) {
    const PolynomialNumbers<S> slope = slope_weights(times);
    b = 1 / slope[0];
    for (int j = 1; j < times.n; ++j) c[j - 1] = -slope[j] / slope[0];
  }
};

/// BDF of one order. With given steps a model of the concept Method; ErrorControl lets it choose its steps.
template <HasSprings System>
requires HasInternalRows<System>
class BDF {
 public:
  using S = typename System::Scalar;

  /// The order is 1 to 5.
  BDF(int order, const NewtonOptions& newton) : order_(order), newton_(newton), start_({}, newton) {}

  /// A given step. Where the length changes, the method starts again with Radau IIA, since given lengths may
  /// change by more than most_growth allows.
  void step(System& system, S& t, StateVector<S>& y, const S& stop) {
    const S h = stop - t;
    // late times are rounded; the formulas take the lengths as they are
    if (!past_.empty() && !is_same_length(h, last_h_, stop)) forget();
    last_h_ = h;
    if (past_.empty()) begin(system, t, y, stop);
    attempt(system, t, stop, y, end_.y);
    accept(system, h, end_.y);
    y = past_.front().y;
    t = stop;
  }
  void begin(System& system, const S& t, const StateVector<S>& y, const S& /*stop*/) {
    forget();
    end_.y = y;
    solve(system, t, end_.y);
    remember();
  }
  /// Solves a step from (t, y) to `stop`, whose end is `reached`. Nothing is remembered before `accept`.
  void attempt(System& system, const S& t, const S& stop, const StateVector<S>& y, StateVector<S>& reached) {
    reached = y;
    if (static_cast<int>(past_.size()) < order_)
      start(system, t, stop, reached);
    else
      advance(system, stop, stop - t, reached);
  }
  /// Accepts the step of length h that was solved last.
  void accept(System&, const S& h, const StateVector<S>& reached) {
    start_is_ahead_ = false;
    end_.h = h;
    end_.y = reached;
    remember();
    ++counters_.steps;
  }
  /// Newton::filter with the matrix of the step that was solved last.
  void filter(System& system, StateVector<S>& change) { newton_.filter(system, change); }
  void restart() {
    forget();
    ++counters_.restarts;
  }
  /// The formulas are unstable if each step is longer than the one before by more than the
  /// factors 2.41, 1.61, 1.28 and 1.12 (orders 2 to 5): the largest root of their first characteristic
  /// polynomial, other than 1, then exceeds 1 in magnitude. The values returned are below
  /// these limits.
  static double most_growth(int order) {
    constexpr std::array<double, 5> most{2, 2, 1.5, 1.25, 1.1};
    return most[static_cast<std::size_t>(order - 1)];
  }
  bool shorten() { return false; }
  const Counters& counters() const { return counters_; }
  const StateVector<S>* lambda() const { return past_.empty() ? nullptr : &past_.front().lambda; }

 private:
  struct Point {
    StateVector<S> y, v_dot, lambda;
    S h{0};  ///< length of the step that ended here [s]
  };

  void forget() {
    past_.clear();
    start_.restart();
    start_is_ahead_ = false;
  }
  /// v' and lambda at a state, from the equations of index 1.
  void solve(System& system, const S& t, const StateVector<S>& y) {
    system.accelerations(t, y, x_.v_dot, x_.lambda);
    ++counters_.right_sides;
  }
  /// Puts `end_` in front, with v' and lambda of x_. It takes the place of the oldest state if there are as
  /// many as the order.
  void remember() {
    end_.v_dot = x_.v_dot;
    end_.lambda = x_.lambda;
    if (static_cast<int>(past_.size()) < order_) past_.emplace_back();
    std::rotate(past_.begin(), past_.end() - 1, past_.end());
    std::swap(past_.front(), end_);
  }

  void start(System& system, const S& t, const S& stop, StateVector<S>& y) {
    if (std::exchange(start_is_ahead_, true)) start_.restart();  // its last step was not accepted
    const Counters before = start_.counters();
    S time = t;
    start_.step(system, time, y, stop);
    counters_.right_sides += start_.counters().right_sides - before.right_sides;
    counters_.iterations += start_.counters().iterations - before.iterations;
    solve(system, stop, y);
    newton_.factor(system, stop, y);
  }

  void advance(System& system, const S& t, const S& h, StateVector<S>& y) {
    const int nq = system.position_size(), nv = system.velocity_size();
    PolynomialNumbers<S> times;  // in steps, so that equal steps give the same formula everywhere
    times.add(S(0));
    S time(-1);
    for (const Point& point : past_) {
      times.add(time);
      time -= is_same_length(point.h, h) ? S(1) : S(point.h / h);
    }
    const BackwardFormula<S> formula(times);
    const S b = formula.b * h;
    // the known part of the formulas for theta (the displacement from q_n), v and the work
    theta_known_.setZero(nv);
    known_.setZero(y.size() - nq);
    for (int j = 0; j < order_; ++j) {
      const S& c = formula.c[j];
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
    PolynomialNumbers<S> past = times;
    for (int j = 0; j < order_; ++j) past.of[j] = times[j + 1];
    past.n = order_;
    const PolynomialNumbers<S> ahead = value_weights(past, S(0));
    predict(ahead, &Point::v_dot, x_.v_dot);
    predict(ahead, &Point::lambda, x_.lambda);
    newton_(system, t, {b * b, b}, place, y, x_, counters_);
    if (y.size() > nq + nv) y[nq + nv] = known_[nv] + b * system.work_rate(newton_.at(), x_.lambda);
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
  void predict(const PolynomialNumbers<S>& weights, StateVector<S> Point::*of, StateVector<S>& sum) const {
    sum.setZero((past_[0].*of).size());
    for (int j = 0; j < weights.n; ++j) sum += weights[j] * (past_[j].*of);
  }

  const int order_;
  Newton<System> newton_;
  Radau5<System> start_;
  std::vector<Point> past_;      ///< the latest first
  Point end_;                    ///< the end of the step that is tried
  S last_h_{0};                  ///< length of the last given step [s]
  bool start_is_ahead_ = false;  ///< whether start_ has taken a step that was not accepted
  StateVector<S> theta_, theta_known_, known_, rate_, next_, v_;
  StepUnknowns<S> x_;
  Counters counters_;
};

}  // namespace trivium::integrators
