#pragma once
/// The lengths of steps that a method chooses itself, to the tolerances. Here is decided how long the first
/// step is, how long the next one after an estimated error, how much shorter one after a failure, where a
/// step is cut to land on a stop, and when steps have shrunk to nothing, which ends the run. Whether an
/// iteration within a step fails is decided by the method; whether a finished step is taken back, by
/// integrate.hpp.

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

/// A first step for a method of some order: one that moves y by about a hundredth of the size that errors are
/// measured by, and that f does not change much over. Hairer, Norsett, Wanner (1993), II.4.
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
  f(y, f0, t);
  const S d0 = norm(y), d1 = norm(f0);
  const S h0 = d0 < S(1e-5) || d1 < S(1e-5) ? S(1e-6) : S(d0 / d1 / 100);
  f(StateVector<S>(y + h0 * f0), f1, t + h0);
  const S d2 = norm(StateVector<S>(f1 - f0)) / h0, d = d1 > d2 ? d1 : d2;
  const S h1 = d <= S(1e-15) ? S(h0 / 1000 > S(1e-6) ? h0 / 1000 : S(1e-6))
                             : S(pow(S(S(0.01) / d), S(1) / S(order + 1)));
  return 100 * h0 < h1 ? S(100 * h0) : h1;
}

/// The length of the next step, of all methods that choose their steps.
template <class S>
class StepSizeControl {
 public:
  /// The length to try next, at most to `stop`.
  S length(const S& t, const S& stop) {
    const S room = stop - t;
    lands_ = proposed_ >= room * S(1 - 1e-10);
    cut_ = proposed_ > room / 2;
    tried_ = lands_ ? room : cut_ ? S(room / 2) : proposed_;  // half of the way: leaves no crumb
    return tried_;
  }
  /// The step was taken; the method says what it would take next.
  void accept(S& t, const S& moved, const S& stop, const S& next) {
    t = lands_ ? stop : moved;
    // a step cut short says little of the next
    proposed_ = cut_ && proposed_ > next ? proposed_ : next;
    if (!(proposed_ > limit_)) return;
    proposed_ = limit_;
    limit_ = limit_growth_ * limit_;
    limit_growth_ = std::min(S(8), S(limit_growth_ * limit_growth_));
  }
  void reject(const S& next) { proposed_ = next; }
  /// The step could not be solved: those after it come back to its length slowly at first.
  void fail() {
    proposed_ = tried_ / 4;
    limit_ = tried_ / 2;
    limit_growth_ = S(1.1);
  }
  /// Of the step accepted last.
  void shorten() { proposed_ = tried_ / 4; }

  bool has_begun() const { return proposed_ > S(0); }
  void begin(const S& h) { proposed_ = h; }
  void restart() { *this = {}; }
  /// Beside the rounding of the times between.
  bool is_too_small(const S& t, const S& stop) const {
    using std::abs, std::max;
    return !(proposed_ > 4 * std::numeric_limits<S>::epsilon() * max(S(abs(t)), S(abs(stop))));
  }

 private:
  S proposed_{0}, tried_{0};                ///< for the next step; of the step tried last
  S limit_{std::numeric_limits<S>::max()};  ///< above which a step failed of late
  S limit_growth_{1};                       ///< by which the limit grows with each step that it held back
  bool lands_ = false, cut_ = false;        ///< the step tried last ends on a stop; is shorter than proposed
};

/// Of a step, to where it ends: numbers whose squares are numbers.
template <class S>
void require_finite(const StateVector<S>& y, const S& t) {
  if (!y.allFinite() || !(y.cwiseAbs().maxCoeff() < S(1e100)))
    throw IntegrationError({{}, static_cast<double>(t)},
                           "the motion is not finite any more; take smaller steps");
}

/// Ends the run, with the reason that is known.
template <FirstOrderSystem System>
[[noreturn]] void give_up(System& system, const typename System::Scalar& t,
                          const StateVector<typename System::Scalar>& y, std::string why) {
  // there are none
  constexpr std::string_view advice = "; take smaller steps";
  if (why.ends_with(advice)) why.resize(why.size() - advice.size());
  const std::string diagnose = system.diagnose(t, y);
  throw IntegrationError(
      {{}, static_cast<double>(t)},
      fmt::format("the steps have shrunk to nothing{}{}", why.empty() ? "" : ": " + why,
                  diagnose.empty() ? "; looser tolerances or another method may pass" : "; " + diagnose));
}

/// How long the next step may be beside one of an estimated error, in tolerances: 0.9 error^power, to `most`.
template <class S>
struct StepRule {
  S power, most;

  S operator()(const S& error) const {
    using std::pow;
    const S factor = error == S(0) ? most : S(S(0.9) * pow(error, power));
    return std::min(most, std::max(S(0.2), factor));
  }
};

/// Tries lengths until `attempt(h)` estimates an error of at most 1; `accept(h)` then takes the step. Where
/// an attempt throws a runtime_error, a quarter is tried. Gives up where none is left to try.
template <FirstOrderSystem System, class Attempt, class Accept>
void take_chosen_step(System& system, StepSizeControl<typename System::Scalar>& step_size,
                      const StepRule<typename System::Scalar>& rule, Counters& counters,
                      typename System::Scalar& t, const StateVector<typename System::Scalar>& y,
                      const typename System::Scalar& stop, const Attempt& attempt, const Accept& accept) {
  using S = typename System::Scalar;
  for (std::string trouble;;) {
    if (step_size.is_too_small(t, stop)) give_up(system, t, y, trouble);
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
    } catch (const std::runtime_error& failure) {
      trouble = failure.what();
      step_size.fail();
    }
    ++counters.rejected_steps;
  }
}

}  // namespace trivium::integrators
