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
/// count in the same way, with the distances l of the bodies from the origin. d and l stay the same until the
/// next restart, so that Q depends on the state alone.
///
/// A step that ends at a stop of the run (an event, the end) is shorter than the rule says, and so is a step
/// after one that could not be solved. Outputs do not limit steps: a step of its own leads from the start of
/// the step to the time of an output.

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "integrators/error_norm.hpp"
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
    if (std::exchange(is_between_, false)) method_.recall(system, t, y, end_.memory);
    start_ = {t, y, method_.memory()};
    const S at_start = suited_, room = stop - t;
    S h = std::exchange(shortened_, S(0)), tried = h;
    bool is_free = !(h > S(0));  // to follow the rule
    if (is_free) h = at_start;
    std::string trouble;
    for (int k = 0; k < most_iterations; ++k) {
      if (is_within_rounding(h, t, stop)) give_up(system, t, start_.y, trouble);
      if (k > 0) method_.recall(system, t, y, start_.memory);
      const bool lands = lands_on_stop(h, room);
      S time = t;
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
        y = start_.y;
        continue;
      }
      const S next = (at_start + suited_) / 2, change = next - h, last = h - tried;
      if (lands || !is_free || k == most_iterations - 1 || abs(change) <= S(enough) * h) {
        t = time;
        break;
      }
      --not_kept_;
      y = start_.y;
      tried = h;
      h = next;
      // Aitken's extrapolation of the last three lengths, where they converge
      if (k % 2 == 1 && abs(change) < abs(last) / 2) h += change * change / (last - change);
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
    is_between_ = true;
    suited_ = suited(*system_, start_.t, start_.y);
    --not_kept_;
    ++rejected_;
    count();
    return true;
  }
  const Counters& counters() const { return counters_; }
  const StateVector<S>* lambda() const { return method_.lambda(); }

  bool interpolates() const { return true; }
  /// A step from the start of the last step to t, or the end of the last step.
  void interpolate(const S& t, StateVector<S>& y) {
    const Point& from = t == end_.t ? end_ : start_;
    y = from.y;
    method_.recall(*system_, from.t, y, from.memory);
    if (t == end_.t) return;
    S time = from.t;
    method_.step(*system_, time, y, t);
    --not_kept_;
    is_between_ = true;
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
    longest_ = stop - t;
    system.position_sizes(y, sizes_);
    spacing_ = first_step(system, t, y, 2, tolerances_, right_sides_);
    spacing_ = suited(system, t, y) / 8;
    suited_ = suited(system, t, y);
    method_.begin(system, t, y, t + std::min(suited_, longest_));
    is_between_ = false;
    shortened_ = S(0);
  }
  /// Q at (t, y); at most the length of the run.
  S suited(System& system, const S& t, const StateVector<S>& y) {
    using std::pow, std::sqrt;
    const int nq = system.position_size(), nv = system.velocity_size();
    v_ = y.segment(nq, nv);
    system.accelerations(t, y, v_dot_, lambda_);
    near_ = y;
    for (const int k : {0, 1}) {
      const S by = k == 0 ? S(-spacing_) : spacing_;
      system.displace(y, by * v_ + by * by / 2 * v_dot_, near_);
      near_.segment(nq, nv) = v_ + by * v_dot_;
      system.accelerations(t + by, near_, v_dot_at_[k], lambda_);
    }
    right_sides_ += 3;
    v_ddot_ = (v_dot_at_[1] - v_dot_at_[0]) / (2 * spacing_);
    none_.setZero(nv);
    const auto size = [&](const StateVector<S>& q) {
      return in_tolerances<S>(tolerances_, sizes_, none_, none_, q, none_);
    };
    const S l = size(sizes_), by_v = size(v_) / l, by_a = size(v_dot_) / l, by_jerk = size(v_ddot_);
    const S error = S(5) * sqrt(by_jerk * by_jerk + l * l * (pow(by_v, S(6)) + by_a * by_a * by_a));
    return pow(S(error + 1 / (longest_ * longest_ * longest_)), S(-1) / 3);
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
  S longest_{0};             ///< bound of a step, the length of the run [s]
  S spacing_{0};             ///< d [s]
  S suited_{0};              ///< Q at the end of the last step [s]
  S shortened_{0};           ///< length of the next step if the last one was taken back, else 0 [s]
  Point start_, end_;        ///< of the last step
  bool is_between_ = false;  ///< the method was last used for another state than end_
  std::array<StateVector<S>, 2> v_dot_at_;
  StateVector<S> v_, v_dot_, v_ddot_, near_, sizes_, none_, lambda_;
  long right_sides_ = 0, rejected_ = 0, not_kept_ = 0;
  Counters counters_;
};

}  // namespace trivium::integrators
