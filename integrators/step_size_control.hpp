#pragma once
/// The step sizes of methods that choose their steps to meet tolerances. This file decides the first step
/// size, the next one after an error estimate, the shorter one after a failure, the shortening of a step to
/// land on a stop, and when steps have become too small, which ends the run. The method decides whether an
/// iteration within a step fails; integrate.hpp decides whether a finished step is taken back.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "integrators/contract/errors.hpp"
#include "integrators/contract/first_order_system.hpp"
#include "integrators/contract/method.hpp"
#include "integrators/contract/tolerances.hpp"

namespace trivium::integrators {

/// The first step size for a method of this order [s]. It is the step whose error would be about a hundredth
/// of the tolerance, judged by y' and by the change of y' over a trial Euler step, which moves y by a
/// hundredth of its size. It is at most a hundred such trial steps. The algorithm and its constants are those
/// of Hairer, Norsett, Wanner (1993), II.4. Adds the evaluations of y' to `right_sides`.
template <FirstOrderSystem System>
typename System::Scalar first_step(System& system, const typename System::Scalar& t,
                                   const StateVector<typename System::Scalar>& y, int order,
                                   const Tolerances& tolerances, long& right_sides) {
  using S = typename System::Scalar;
  using std::pow, std::sqrt;
  StateVector<S> f0(y.size()), f1(y.size());
  const auto f = [&](const StateVector<S>& at, StateVector<S>& rate, const S& time) {
    ++right_sides;
    system.derivative(time, at, rate);
  };
  const auto norm = [&](const StateVector<S>& x) {
    S sum(0);
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      using std::abs;
      const S scaled = x[k] / (S(tolerances.atol) + S(tolerances.rtol) * abs(y[k]));
      sum += scaled * scaled;
    }
    return S(sqrt(sum / S(static_cast<double>(x.size()))));
  };
  using std::isfinite;
  f(y, f0, t);
  const S d0 = norm(y), d1 = norm(f0);
  const S h0 = d0 < S(1e-5) || d1 < S(1e-5) ? S(1e-6) : S(d0 / d1 / 100);
  f(StateVector<S>(y + h0 * f0), f1, t + h0);
  const S d2 = norm(StateVector<S>(f1 - f0)) / h0, d = d1 > d2 ? d1 : d2;
  const S h1 = d <= S(1e-15) ? S(h0 / 1000 > S(1e-6) ? h0 / 1000 : S(1e-6))
                             : S(pow(S(S(0.01) / d), S(1) / S(order + 1)));
  const S h = 100 * h0 < h1 ? S(100 * h0) : h1;
  if (!(h > S(0) && isfinite(h)))
    throw IntegrationError({{}, static_cast<double>(t)},
                           "no first step is short enough for these accelerations; try other tolerances or "
                           "another method");
  return h;
}

/// Whether a step size is within the rounding of the times. A step of 4 epsilon contains only a few
/// representable times, too few for its stages.
template <class S>
bool is_within_rounding(const S& h, const S& t, const S& stop) {
  using std::abs, std::max;
  return !(h > 4 * std::numeric_limits<S>::epsilon() * max(S(abs(t)), S(abs(stop))));
}

/// Whether a step of this size ends on a stop that is `room` ahead. A rest below 1e-10 of a step comes from
/// the rounding of t and must not become a step of its own.
template <class S>
bool lands_on_stop(const S& h, const S& room) {
  return h >= room * S(1 - 1e-10);
}

/// The size of the next step, for all methods that choose their steps.
template <class S>
class StepSizeControl {
 public:
  /// The step size to try next; the step does not go beyond `stop`.
  S length(const S& t, const S& stop) {
    const S room = stop - t;
    lands_ = lands_on_stop(proposed_, room);
    cut_ = proposed_ > room / 2;
    tried_ = lands_ ? room : cut_ ? S(room / 2) : proposed_;  // two halves: no tiny last step
    return tried_;
  }
  /// The step was accepted and ended at `moved`; `next` is the size that the method proposes next.
  void accept(S& t, const S& moved, const S& stop, const S& next) {
    t = lands_ ? stop : moved;
    // a step shortened to land on a stop must not reduce the size of later steps
    proposed_ = cut_ && proposed_ > next ? proposed_ : next;
    if (!(proposed_ > limit_)) return;
    proposed_ = limit_;
    limit_ = limit_growth_ * limit_;
    // 8 is the largest growth of a step in radau.hpp: a limit that grows faster would not limit any more
    limit_growth_ = std::min(S(8), S(limit_growth_ * limit_growth_));
  }
  /// The step was too inaccurate; `next` is the size to try next.
  void reject(const S& next) { proposed_ = next; }
  /// The step could not be solved. A quarter is tried next. The step after it may have up to half of the
  /// size that failed. This limit then grows by 1.1, 1.1^2, 1.1^4 and so on. The factors are chosen by
  /// experiment: with faster growth the steps soon fail again, with slower growth a single failure costs many
  /// short steps.
  void fail() {
    proposed_ = tried_ / 4;
    limit_ = tried_ / 2;
    limit_growth_ = S(1.1);
  }
  /// The step accepted last was taken back. A quarter of it is tried next.
  void shorten() { proposed_ = tried_ / 4; }

  bool has_begun() const { return proposed_ > S(0); }
  /// Sets the size of the first step.
  void begin(const S& h) { proposed_ = h; }
  /// Forgets all sizes.
  void restart() { *this = {}; }
  bool is_too_small(const S& t, const S& stop) const { return is_within_rounding(proposed_, t, stop); }

 private:
  S proposed_{0}, tried_{0};                ///< size of the next step; size of the step tried last
  S limit_{std::numeric_limits<S>::max()};  ///< bound of the step size after a failure
  S limit_growth_{1};                       ///< factor by which limit_ grows each time it bounds a step
  bool lands_ = false, cut_ = false;        ///< whether the last try ends on `stop`; whether it is shortened
};

/// Throws an IntegrationError if y is not finite or above 1e100, the largest number of a scene, where
/// energies could overflow; t is the end of the step.
template <class S>
void require_finite(const StateVector<S>& y, const S& t) {
  if (!y.allFinite() || !(y.cwiseAbs().maxCoeff() < S(1e100)))
    throw IntegrationError({{}, static_cast<double>(t)},
                           "the state is no longer finite, or exceeds 1e100; take smaller steps");
}

/// Ends the run at time t with the reason `why`, if one is known.
[[noreturn]] inline void give_up(double t, const std::string& why) {
  throw IntegrationError({{}, t},
                         fmt::format("the step size has become too small{}{}; try other tolerances or "
                                     "another method",
                                     why.empty() ? "" : ": ", without_advice(why)));
}

/// The factor from a step size to the next: 0.9 error^power, between 0.2 and `most`, for an estimated error
/// in tolerances. The power is negative: -1 / (order of the estimate + 1). 0.9 makes the next step likely to
/// be accepted. The bound 0.2 distrusts estimates far outside the asymptotic range (Hairer, Norsett, Wanner
/// (1993), II.4). A factor between 1 and `least_growth` counts as 1, for methods that lose accuracy or time
/// where the step size changes.
template <class S>
struct StepRule {
  S power, most, least_growth = S(1);

  S operator()(const S& error) const {
    using std::pow;
    const S factor = error == S(0) ? most : S(S(0.9) * pow(error, power));
    if (factor > S(1) && factor < least_growth) return S(1);
    return std::min(most, std::max(S(0.2), factor));
  }
};

/// Tries step sizes until `attempt(h)` returns an estimated error of at most 1 [tolerances]; `accept(h)` then
/// takes the step. After an attempt that throws a runtime_error a quarter of the size is tried. Ends the run
/// if the step size becomes too small.
template <class S, class Attempt, class Accept>
void take_chosen_step(StepSizeControl<S>& step_size, const StepRule<S>& rule, Counters& counters, S& t,
                      const S& stop, const Attempt& attempt, const Accept& accept) {
  for (std::string trouble;;) {
    if (step_size.is_too_small(t, stop)) give_up(static_cast<double>(t), trouble);
    const S h = step_size.length(t, stop);
    try {
      const S error = attempt(h);
      const S next = h * rule(error);
      if (error <= S(1)) {
        accept(h);
        step_size.accept(t, S(t + h), stop, next);
        return;
      }
      trouble.clear();
      step_size.reject(next);
    } catch (const UsageError&) {
      throw;
    } catch (const std::runtime_error& failure) {
      trouble = failure.what();
      step_size.fail();
    }
    ++counters.rejected_steps;
  }
}

}  // namespace trivium::integrators
