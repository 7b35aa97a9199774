#pragma once
/// Chosen steps of Fehlberg 7(8). Its own error estimate compares derivatives at the two ends of a step. It
/// vanishes where y' depends on time alone, and sees nothing of what happens within the step. There the
/// method of order 8 is the rule of Newton and Cotes on the sixths of the step, whose error is
///
///     9/1400 (h/6)^9 f^(8),   and (h/6)^6 f^(6) is about D, the sixth difference of y' on the sixths
///
/// Abramowitz and Stegun, Handbook of Mathematical Functions (1964), 25.4.18. Where derivatives grow evenly
/// with their order and F is the size of y', (h/6)^8 f^(8) is about F (D/F)^(8/6). The second estimate is
/// therefore 9/8400 h F (D/F)^(4/3), for each element of y. Where y' depends on y, stages are less accurate
/// than steps, and the estimate is too large: steps are shorter by a third or so. It counts in full where
/// loads or drivers are functions of time. Elsewhere a hundredth counts, which limits no usual step, but an
/// angle of constant rate makes y' a function of time as well: a crank that turns evenly, in Euler angles.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "integrators/explicit/odeint.hpp"

namespace trivium::integrators {

/// A controlled stepper for Fehlberg 7(8), which rejects a step by either estimate.
template <class S>
class FehlbergControl {
 public:
  FehlbergControl(const Tolerances& tolerances, bool depends_on_time)
      : controlled_(typename Controlled::error_checker_type(S(tolerances.atol), S(tolerances.rtol))),
        tolerances_(tolerances),
        share_(depends_on_time ? 1 : 0.01) {}

  /// Odeint's try_step: after a step y, t and h are those of the next one; after a rejected step h is.
  template <class F>
  odeint::controlled_step_result try_step(const F& f, StateVector<S>& y, const StateVector<S>& y_dot, S& t,
                                          S& h) {
    using std::pow;
    const S begin = t, tried = h;
    before_ = y;
    on_sixths_[0] = y_dot;
    // Of two stages at a node the later one is the more accurate; at the start y_dot is exact. The order of
    // the stages tells their nodes: times that are rounded to a part of a short step do not.
    std::size_t stage = 0;
    const auto recorded = [&](const StateVector<S>& at, StateVector<S>& rate, const S& time) {
      f(at, rate, time);
      if (const std::size_t sixth = sixth_of_stage[stage++]; sixth > 0) on_sixths_[sixth] = rate;
    };
    const auto result = controlled_.try_step(recorded, y, y_dot, t, h);
    if (result != odeint::success) return result;
    const S error = second_error(tried);
    // the safety factor of Odeint's controller, and its limits
    const S change = S(0.9) * pow(S(error + S(1e-9)), S(-1) / 9);
    h = std::min(h, S(tried * std::clamp(change, S(0.2), S(5))));
    if (!(error > S(1))) return result;
    y = before_;
    t = begin;
    return odeint::fail;
  }

 private:
  using Controlled = odeint::controlled_runge_kutta<Fehlberg78<S>>;

  /// Of the second stage to the last: at which sixth of the step it is; 0 if at none, or at the start.
  static constexpr std::array<std::size_t, 12> sixth_of_stage{0, 0, 1, 0, 3, 5, 1, 4, 2, 6, 0, 6};

  /// What counts of the second estimate for a step of length h, in units of the tolerances.
  S second_error(const S& h) const {
    using std::abs, std::cbrt;
    constexpr std::array<int, 7> binomial{1, -6, 15, -20, 15, -6, 1};
    const S atol(tolerances_.atol), rtol(tolerances_.rtol);
    S largest(0);
    for (Eigen::Index k = 0; k < before_.size(); ++k) {
      S D(0), F(0);
      for (std::size_t j = 0; j < binomial.size(); ++j) {
        D += binomial[j] * on_sixths_[j][k];
        F = std::max(F, S(abs(on_sixths_[j][k])));
      }
      if (!(F > S(0))) continue;
      const S ratio = abs(D) / F, error = S(9) / 8400 * h * F * ratio * cbrt(ratio);
      // as in Odeint's checker of errors
      largest = std::max(largest, S(error / (atol + rtol * (abs(before_[k]) + h * abs(on_sixths_[0][k])))));
    }
    return share_ * largest;
  }

  Controlled controlled_;
  const Tolerances tolerances_;
  const S share_;
  StateVector<S> before_;
  std::array<StateVector<S>, 7> on_sixths_;  ///< y' at the nodes 0, 1/6, ... 1
};

}  // namespace trivium::integrators
