#pragma once
/// Steps of RATTLE that are chosen by a rule which is the same forwards and backwards in time. The energy
/// error of a symmetric method with such steps stays bounded, as with constant steps, if the motion itself is
/// the same forwards and backwards, as a swing is. With steps that follow an error estimate of the last step
/// it would grow in any case. The rule is that of Hut, Makino and McMillan, The Astrophysical Journal 443
/// (1995): a step is as long as the mean of the steps that suit its two ends,
///
///   h = (Q(y_n) + Q(y_n+1)) / 2,
///
/// which is solved by iteration. Q(y) [s] is the step whose error of positions h^3 v''/6 would be a thirtieth
/// of the tolerances; v'' is a difference of v' over states at -d, d from the present one. The thirtieth is
/// chosen by experiment, so that the velocities too have errors of the size of the tolerances. v'' alone
/// would vanish where a body turns back: the cubes of |v| / l and of (|v'| / l)^1/2, rates of the motion,
/// count in the same way, with the sizes l of the positions (position_sizes). So does the error of a rotation
/// by theta = h v that v'' does not contain: the part of T(theta)^-1 M theta (rattle.hpp) that is even in h,
/// theta x (theta x M theta) / 12, turns a body with a small moment of inertia by M^-1 times it. Where a load
/// changes fast beside these rates, velocities have larger errors than positions: there Q is the step whose
/// error of velocities, h^3 v'''/12, would be the tolerances; sizes of velocities are the rates times l. d
/// and l stay the same until the next restart, so that Q depends on the state alone. Where Q changes more
/// than threefold within a step, as where a load sets in, the mean would not see the shorter one: such a step
/// has twice its length.
///
/// A step that ends at a stop of the run (an event, the end) is shorter than the rule says, and so is a step
/// after one that could not be solved. Outputs do not limit steps: the state at an output within a step is
/// Hermite's cubic polynomial through the two ends of the step and their rates, projected onto the
/// constraints.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "integrators/error_norm.hpp"
#include "integrators/projection_iteration.hpp"
#include "integrators/step_size_control.hpp"
#include "integrators/symplectic/rattle.hpp"

namespace trivium::integrators {

/// RATTLE with these chosen steps, as a model of the concept Method.
template <HasNewtonMatrix System>
class ReversibleSteps {
 public:
  using S = typename System::Scalar;

  ReversibleSteps(Rattle<System> method, const Tolerances& tolerances)
      : method_(std::move(method)), tolerances_(tolerances) {}

  void step(System& system, S& t, StateVector<S>& y, const S& stop) {
    using std::abs;
    system_ = &system;
    if (!method_.has_begun()) begin(system, t, y, stop);
    const S at_start = suited_, room = stop - t;
    S h = std::exchange(shortened_, S(0)), tried = h;
    bool is_free = !(h > S(0));  // to follow the rule
    if (is_free)
      h = at_start;
    else
      method_.recall(system, t, y, end_.memory);
    is_between_ = has_rates_ = false;
    start_ = {t, y, method_.memory()};
    smooth_until_ = stop;
    std::string trouble;
    for (int k = 0, attempts = 0;; ++attempts) {
      if (is_within_rounding(h, t, stop)) give_up(static_cast<double>(t), trouble);
      if (attempts > 0) {
        y = start_.y;
        method_.recall(system, t, y, start_.memory);
      }
      const bool lands = lands_on_stop(h, room);
      S time = t;
      const long steps_before = method_.counters().steps;
      try {
        method_.step(system, time, y, lands ? stop : S(t + h));
        require_finite(y, time);
        suited_ = suited(system, time, y);
      } catch (const UsageError&) {
        throw;
      } catch (const std::runtime_error& failure) {
        trouble = failure.what();
        is_free = false;
        h /= 4;
        ++rejected_;
        not_kept_ -= method_.counters().steps - steps_before;
        continue;
      }
      const S next = std::min(S((at_start + suited_) / 2), S(2 * std::min(at_start, suited_)));
      const S change = next - h, last = h - tried;
      if (lands || !is_free || ++k == most_iterations || abs(change) <= S(enough) * h) {
        t = time;
        break;
      }
      --not_kept_;
      tried = h;
      h = next;
      // Aitken's extrapolation of the last three lengths, where they converge
      if (k % 2 == 0 && abs(change) < abs(last) / 2)
        h = std::clamp(S(h + change * change / (last - change)), S(next / 2), S(2 * next));
    }
    end_ = {t, y, method_.memory()};
    count();
  }
  void restart() {
    method_.restart();
    count();
  }
  /// The last step is taken back; the next one has a quarter of its length.
  bool shorten() {
    shortened_ = (end_.t - start_.t) / 4;
    end_ = start_;
    is_between_ = false;
    suited_ = suited(*system_, start_.t, start_.y);
    --not_kept_;
    ++rejected_;
    count();
    return true;
  }
  const Counters& counters() const { return counters_; }
  const StateVector<S>* lambda() const { return is_between_ ? &lambda_between_ : method_.lambda(); }

  bool interpolates() const { return true; }
  /// The state at a time within the last step, or at its end.
  void interpolate(const S& t, StateVector<S>& y) {
    is_between_ = t != end_.t;
    if (!is_between_) {
      y = end_.y;
      return;
    }
    const S h = end_.t - start_.t, s = (t - start_.t) / h, left = 1 - s;
    if (!std::exchange(has_rates_, true)) {
      system_->derivative(start_.t, start_.y, rate_at_[0]);
      system_->derivative(end_.t, end_.y, rate_at_[1]);
      right_sides_ += 2;
    }
    y = left * left * (1 + 2 * s) * start_.y + s * s * (1 + 2 * left) * end_.y +
        h * s * left * (left * rate_at_[0] - s * rate_at_[1]);
    ProjectionReport<S> of_interpolation;  // not part of the report: steps are not projected
    project_(*system_, t, y, of_interpolation);
    lambda_between_ = left * start_.memory.lambda + s * end_.memory.lambda;
    count();
  }

 private:
  struct Point {
    S t{0};
    StateVector<S> y;
    typename Rattle<System>::Memory memory;
  };

  /// Relative change [-] of the length at which the iteration ends. Lengths that miss the rule by this much
  /// change the energy error of a step by the same share; chosen by experiment. 20 is a safety limit.
  static constexpr double enough = 1e-6;
  static constexpr int most_iterations = 20;

  void begin(System& system, const S& t, const StateVector<S>& y, const S& stop) {
    smooth_from_ = t;
    smooth_until_ = stop;
    longest_ = stop - t;
    system.position_sizes(y, sizes_);
    spacing_ = std::min(first_step(system, t, y, 2, tolerances_, right_sides_), S(longest_ / 2));
    // d is an eighth of the first step: short beside the changes of v'', long beside rounding
    spacing_ = suited(system, t, y) / 8;
    suited_ = suited(system, t, y);
    method_.begin(system, t, y, t + std::min(suited_, longest_));
    is_between_ = false;
    shortened_ = S(0);
  }
  /// Q at (t, y); at most the length that the first step after the restart was allowed.
  S suited(System& system, const S& t, const StateVector<S>& y) {
    using std::pow, std::sqrt;
    const int nq = system.position_size(), nv = system.velocity_size();
    v_ = y.segment(nq, nv);
    system.accelerations(t, y, v_dot_, lambda_);
    near_ = y;
    // no model from before the last event or beyond the next one
    const S d = spacing_, middle = std::max(std::min(t, S(smooth_until_ - d)), S(smooth_from_ + d));
    const std::array<S, 3> at{middle - d, middle, std::min(S(middle + d), smooth_until_)};
    for (const int k : {0, 1, 2}) {
      if (at[k] == t) {
        v_dot_at_[k] = v_dot_;
        continue;
      }
      const S by = at[k] - t;
      system.displace(y, by * v_ + by * by / 2 * v_dot_, near_);
      near_.segment(nq, nv) = v_ + by * v_dot_;
      system.accelerations(at[k], near_, v_dot_at_[k], lambda_);
      ++right_sides_;
    }
    ++right_sides_;
    v_ddot_ = (v_dot_at_[2] - v_dot_at_[0]) / (at[2] - at[0]);
    v_dddot_ = (v_dot_at_[2] - 2 * v_dot_at_[1] + v_dot_at_[0]) / (d * d);
    none_.setZero(nv);
    const auto size = [&](const StateVector<S>& q) {
      return in_tolerances<S>(tolerances_, sizes_, none_, none_, q, none_);
    };
    const S l = size(sizes_), by_v = size(v_) / l, by_a = size(v_dot_) / l, by_jerk = size(v_ddot_),
            by_turn = 6 * size(even_part(system, t, y)),
            by_change = by_a * by_a * l / (by_jerk + std::numeric_limits<S>::min()),
            rate = std::max(by_v, std::min(S(sqrt(by_a)), by_change));
    speeds_ = rate * sizes_;
    const S of_velocities = in_tolerances<S>(tolerances_, sizes_, speeds_, none_, none_, v_dddot_);
    const S error = std::max(S(S(5) * sqrt(by_jerk * by_jerk + by_turn * by_turn +
                                           l * l * (pow(by_v, S(6)) + by_a * by_a * by_a))),
                             S(of_velocities / 12));
    const S suited = pow(S(error + 1 / (longest_ * longest_ * longest_)), S(-1) / 3);
    if (!(suited > S(0)))  // NaN too: accelerations whose change overflows
      throw IntegrationError(
          {{}, static_cast<double>(t)},
          "no step is short enough for these accelerations; try other tolerances or another "
          "method");
    return suited;
  }
  /// The motion per s^3 that the even part of T(theta)^-1 M theta causes, see above.
  const StateVector<S>& even_part(System& system, const S& t, const StateVector<S>& y) {
    system.evaluate(t, y, at_);
    // rotations of a tenth of a radian: higher powers are small, and rounding is too
    const S fastest = v_.cwiseAbs().maxCoeff(), s = S(0.1) / std::max(fastest, S(1e-30));
    theta_ = s * v_;
    system.inertia_force(at_, theta_, momentum_);
    system.displacement_rate(theta_, momentum_, even_);
    theta_ = -theta_;
    system.displacement_rate(theta_, momentum_, back_);
    even_ = (even_ / 2 + back_ / 2 - momentum_) / (s * s * s);
    system.factor(at_, {}, factors_);
    system.reduce(factors_, even_, reduced_);
    no_rows_.setZero(system.multipliers());
    turn_.setZero(v_.size());
    lambda_.setZero(system.multipliers());
    system.solve(factors_, at_, reduced_, no_rows_, turn_, lambda_);
    return turn_;
  }
  void count() {
    counters_ = method_.counters();
    counters_.steps += not_kept_;
    counters_.rejected_steps = rejected_;
    counters_.right_sides += right_sides_;
  }

  Rattle<System> method_;
  const Tolerances tolerances_;
  System* system_ = nullptr;
  S longest_{0};  ///< bound of a step: the length allowed for the first one after the restart [s]
  S spacing_{0};  ///< d [s]
  S smooth_from_{0}, smooth_until_{0};  ///< the last restart; the latest end allowed for the step [s]
  S suited_{0};                         ///< Q at the end of the last step [s]
  S shortened_{0};           ///< length of the next step if the last one was taken back, else 0 [s]
  Point start_, end_;        ///< of the last step
  bool is_between_ = false;  ///< the state asked for last was within a step
  bool has_rates_ = false;   ///< rate_at_ belongs to the last step
  ProjectionIteration<System> project_;
  std::array<StateVector<S>, 3> v_dot_at_;
  std::array<StateVector<S>, 2> rate_at_;
  StateVector<S> lambda_between_;
  StateVector<S> v_, v_dot_, v_ddot_, v_dddot_, near_, sizes_, speeds_, none_, lambda_;
  typename System::Evaluation at_;
  typename System::Factors factors_;
  StateVector<S> theta_, momentum_, even_, back_, reduced_, no_rows_, turn_;  ///< of even_part
  long right_sides_ = 0, rejected_ = 0, not_kept_ = 0;
  Counters counters_;
};

}  // namespace trivium::integrators
