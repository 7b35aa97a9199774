#pragma once
/// Chosen steps for methods that have no error estimate of their own. The end of a step is compared with the
/// formula of Adams and Moulton of one order more than the method's: it integrates the velocities and
/// accelerations at the end of the step and at the states before it,
///
///     theta_n+1 = integral of T(theta)^-1 v,   v_n+1 = v_n + integral of v'
///
/// with theta the displacement from q_n, T(theta)^-1 v its rate (displacement_rate), and v' solved from the
/// equations of index 1. If the method has a filter (Newton::filter), only the part of the velocity
/// difference that the constraints admit counts. The steps may differ in length. The first steps, which have
/// fewer states before them, are compared with formulas of lower order.

#include <algorithm>
#include <utility>
#include <vector>

#include "integrators/contract/residual.hpp"
#include "integrators/error_norm.hpp"
#include "integrators/lagrange.hpp"
#include "integrators/step_size_control.hpp"

namespace trivium::integrators {

/// A method whose steps can be solved without being accepted:
///
///   begin                from (t, y, stop): begins at (t, y), with `stop` as the end of the first step
///   attempt              from (t, stop, y, reached): solves a step from (t, y) to `stop`, with `reached` as
///                        its end
///   accept               from (h, reached): accepts the step of length h that was solved last
template <class M, class System>
concept Attempts = requires(M& method, System& system, const typename System::Scalar& t,
                            const StateVector<typename System::Scalar>& y,
                            StateVector<typename System::Scalar>& reached) {
  method.begin(system, t, y, t);
  method.attempt(system, t, t, y, reached);
  method.accept(system, t, reached);
};

/// The method M with chosen steps, as a model of the concept Method.
template <class M, HasResidual System>
requires Attempts<M, System>
class ErrorControl {
 public:
  using S = typename System::Scalar;

  /// `order` of the method, 1 to 5. A step is at most `most_growth` times as long as the one before, so that
  /// formulas of several steps remain stable.
  ErrorControl(M method, int order, const Tolerances& tolerances, double most_growth)
      : method_(std::move(method)), order_(order), tolerances_(tolerances), most_growth_(most_growth) {}

  void step(System& system, S& t, StateVector<S>& y, const S& stop) {
    if (past_.empty()) begin(system, t, y);
    past_.front().y = y;  // the end of the last step may have been projected since
    // Growth below (most_growth - 1) / 5 counts as none: where the length changes, generalised-alpha and HHT
    // evaluate the accelerations once more. A fifth is chosen by experiment.
    const StepRule<S> rule{S(-1) / (order_ + 1), S(most_growth_), S(1) + S(most_growth_ - 1) / 5};
    take_chosen_step(
        step_size_, rule, counters_, t, stop,
        [&](const S& h) {
          if (!has_stepped_) method_.begin(system, t, y, S(t + h));
          method_.attempt(system, t, S(t + h), y, end_.y);
          require_finite(end_.y, S(t + h));
          return with_last(error_of(system, t, h), h);
        },
        [&](const S& h) {
          method_.accept(system, h, end_.y);
          y = end_.y;
          end_.h = h;
          last_error_ = error_;
          has_stepped_ = true;
          remember();
        });
    count();
  }
  void restart() {
    forget();
    step_size_.restart();
    ++counters_.restarts;
  }
  bool shorten() {
    forget();
    step_size_.shorten();
    ++counters_.rejected_steps;
    --taken_back_;
    count();
    return true;
  }
  const Counters& counters() const { return counters_; }
  auto lambda() const { return has_stepped_ ? method_.lambda() : nullptr; }

 private:
  struct Point {
    StateVector<S> y, v_dot;
    S h{0};  ///< length of the step that ended here [s]
  };

  void forget() {
    past_.clear();
    has_stepped_ = false;
    method_.restart();
  }
  void begin(System& system, const S& t, const StateVector<S>& y) {
    if (!step_size_.has_begun())
      step_size_.begin(first_step(system, t, y, order_, tolerances_, own_right_sides_));
    end_.y = y;
    accelerations(system, t);
    remember();
  }
  /// v' at the end of a step.
  void accelerations(System& system, const S& t) {
    system.accelerations(t, end_.y, end_.v_dot, lambda_);
    ++own_right_sides_;
  }
  /// Puts the end of a step in front of the past points; at most as many stay as the order.
  void remember() {
    if (static_cast<int>(past_.size()) < order_) past_.emplace_back();
    std::rotate(past_.begin(), past_.end() - 1, past_.end());
    std::swap(past_.front(), end_);
  }

  /// The estimated error [tolerances] of the step of length h from t that ended at end_.y.
  S error_of(System& system, const S& t, const S& h) {
    accelerations(system, S(t + h));
    const int nq = system.position_size(), nv = system.velocity_size();
    const StateVector<S>& start = past_.front().y;
    PolynomialNumbers<S> times;  // since the start of the step
    times.add(h);
    S time(0);
    for (const Point& point : past_) {
      times.add(time);
      time -= point.h;
    }
    const PolynomialNumbers<S> weights = integral_weights(times, S(0), h);
    system.displacement(start, end_.y, of_q_);
    of_v_ = end_.y.segment(nq, nv) - start.segment(nq, nv);
    for (int k = 0; k < weights.n; ++k) {
      const Point& point = k == 0 ? end_ : past_[k - 1];
      v_ = point.y.segment(nq, nv);
      system.displacement(start, point.y, theta_);
      system.displacement_rate(theta_, v_, rate_);
      of_q_ -= weights[k] * rate_;
      of_v_ -= weights[k] * point.v_dot;
    }
    // With index 3 the velocities miss their rows by c h^2. Between two steps this changes by
    // c (h^2 - h_last^2), which does not accumulate: it is no error of the step.
    if constexpr (requires { method_.filter(system, of_v_); }) method_.filter(system, of_v_);
    system.position_sizes(start, sizes_);
    return in_tolerances<S>(tolerances_, sizes_, start.segment(nq, nv), end_.y.segment(nq, nv), of_q_, of_v_);
  }

  /// The error that decides about the size of the next step. Estimates with index 3 alternate between large
  /// and small, hence the larger of this error and that of the last step, as it would be with this h; but the
  /// step is accepted by its own error.
  S with_last(const S& error, const S& h) {
    using std::pow;
    error_ = error;
    if (!has_stepped_) return error;
    const S last = last_error_ * pow(S(h / past_.front().h), S(order_ + 1));
    return std::max(error, std::min(S(1), last));
  }

  /// Adds up the work of the method and of the estimates.
  void count() {
    const Counters& of_method = method_.counters();
    counters_.steps = of_method.steps + taken_back_;
    counters_.right_sides = of_method.right_sides + own_right_sides_;
    counters_.iterations = of_method.iterations;
  }

  M method_;
  const int order_;
  const Tolerances tolerances_;
  const double most_growth_;
  StepSizeControl<S> step_size_;
  bool has_stepped_ = false;  ///< since the last restart
  std::vector<Point> past_;   ///< states that the motion has reached, the latest first
  Point end_;                 ///< end of the step that is tried
  StateVector<S> of_q_, of_v_, theta_, v_, rate_, sizes_, lambda_;
  S error_{0}, last_error_{0};  ///< of this step and of the last one [tolerances]
  long own_right_sides_ = 0, taken_back_ = 0;
  Counters counters_;
};

}  // namespace trivium::integrators
