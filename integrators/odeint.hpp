#pragma once
/// Boost.Odeint's explicit methods on y' = f(t, y): Dormand-Prince 5(4), Fehlberg 7(8), Bulirsch-Stoer and
/// Adams-Bashforth-Moulton, with steps of their own choice or of a given length.

#include <fmt/format.h>

#include <boost/numeric/odeint/algebra/range_algebra.hpp>
#include <boost/numeric/odeint/external/eigen/eigen_resize.hpp>
#include <boost/numeric/odeint/stepper/adams_bashforth_moulton.hpp>
#include <boost/numeric/odeint/stepper/adaptive_adams_bashforth_moulton.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/controlled_adams_bashforth_moulton.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

#include "integrators/system.hpp"

namespace trivium::integrators {

namespace odeint = boost::numeric::odeint;

/// Of scalars that are classes too; and a number that is none is larger than any.
struct FlatAlgebra : odeint::range_algebra {
  template <class V>
  static typename V::Scalar norm_inf(const V& v) {
    using std::abs;
    typename V::Scalar largest(0);
    for (Eigen::Index k = 0; k < v.size(); ++k) {
      const typename V::Scalar size = abs(v[k]);
      if (!(size <= std::numeric_limits<typename V::Scalar>::max()))
        return std::numeric_limits<typename V::Scalar>::infinity();
      if (size > largest) largest = size;
    }
    return largest;
  }
};

template <class S>
using DormandPrince5 = odeint::runge_kutta_dopri5<Flat<S>, S, Flat<S>, S, FlatAlgebra>;
template <class S>
using Fehlberg78 = odeint::runge_kutta_fehlberg78<Flat<S>, S, Flat<S>, S, FlatAlgebra>;
template <class S>
using BulirschStoer = odeint::bulirsch_stoer<Flat<S>, S, Flat<S>, S, FlatAlgebra>;
/// Of given steps: predicts with 5 steps and corrects with 5; starts with Fehlberg 7(8).
template <class S>
using AdamsBashforthMoulton =
    odeint::adams_bashforth_moulton<5, Flat<S>, S, Flat<S>, S, FlatAlgebra, odeint::default_operations,
                                    odeint::initially_resizer, Fehlberg78<S>>;
/// Of steps and orders of its own choice, up to 12.
using AdaptiveAdams =
    odeint::adaptive_adams_bashforth_moulton<12, Flat<double>, double, Flat<double>, double, FlatAlgebra>;

/// f as Odeint calls it, counted.
template <FirstOrderSystem System>
struct RightSide {
  using S = typename System::Scalar;
  System& system;
  long& calls;

  void operator()(const Flat<S>& y, Flat<S>& y_dot, const S& t) const {
    ++calls;
    system.derivative(t, y, y_dot);
  }
};

/// A first step for a method of some order: one that moves y by about a hundredth of the size that errors are
/// measured by, and that f does not change much over. Hairer, Norsett, Wanner (1993), II.4.
template <FirstOrderSystem System>
typename System::Scalar first_step(System& system, const typename System::Scalar& t,
                                   const Flat<typename System::Scalar>& y, int order,
                                   const Tolerances& tolerances, long& right_sides) {
  using S = typename System::Scalar;
  using std::pow, std::sqrt;
  Flat<S> f0(y.size()), f1(y.size());
  const RightSide<System> f{system, right_sides};
  const auto norm = [&](const Flat<S>& x) {
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
  f(Flat<S>(y + h0 * f0), f1, t + h0);
  const S d2 = norm(Flat<S>(f1 - f0)) / h0, d = d1 > d2 ? d1 : d2;
  const S h1 = d <= S(1e-15) ? S(h0 / 1000 > S(1e-6) ? h0 / 1000 : S(1e-6))
                             : S(pow(S(S(0.01) / d), S(1) / S(order + 1)));
  return 100 * h0 < h1 ? S(100 * h0) : h1;
}

/// What all methods that choose their steps have in common: where steps end, and giving up.
template <class S>
class StepChoice {
 public:
  /// The length to try next, at most to `stop`.
  S length(const S& t, const S& stop) {
    const S room = stop - t;
    lands_ = wanted_ >= room * S(1 - 1e-10);
    cut_ = wanted_ > room / 2;
    tried_ = lands_ ? room : cut_ ? S(room / 2) : wanted_;  // half of the way: leaves no crumb
    return tried_;
  }
  /// The step was taken; the method says what it would take next.
  void accept(S& t, const S& moved, const S& stop, const S& next) {
    t = lands_ ? stop : moved;
    // a step cut short says little of the next
    wanted_ = cut_ && wanted_ > next ? wanted_ : next;
  }
  void reject(const S& next) { wanted_ = next; }
  /// Of the step accepted last.
  void shorten() { wanted_ = tried_ / 4; }

  bool has_begun() const { return wanted_ > S(0); }
  void begin(const S& h) { wanted_ = h; }
  void restart() { wanted_ = S(0); }
  bool is_too_small(const S& t) const {
    using std::abs;
    const S least = std::numeric_limits<S>::min();
    return !(wanted_ > 4 * std::numeric_limits<S>::epsilon() * abs(t)) || !(wanted_ > least);
  }

 private:
  S wanted_{0}, tried_{0};
  bool lands_ = false, cut_ = false;
};

template <FirstOrderSystem System>
[[noreturn]] void give_up(System& system, const typename System::Scalar& t,
                          const Flat<typename System::Scalar>& y, const std::string& why) {
  const std::string suspect = system.suspect(t, y);
  throw IntegrationError(
      fmt::format("at t = {}: the steps have shrunk to nothing{}{}", static_cast<double>(t),
                  why.empty() ? "" : ": " + why,
                  suspect.empty() ? "; looser tolerances, or an implicit method, may pass" : "; " + suspect));
}

/// An Odeint controlled stepper: steps of its own choice.
template <class S, class Controlled>
class ChosenSteps {
 public:
  ChosenSteps(Controlled controlled, int order, const Tolerances& tolerances)
      : controlled_(std::move(controlled)), order_(order), tolerances_(tolerances) {}

  template <FirstOrderSystem System>
  void step(System& system, S& t, Flat<S>& y, const S& stop) {
    RightSide<System> f{system, counters_.right_sides};
    if (!choice_.has_begun())
      choice_.begin(first_step(system, t, y, order_, tolerances_, counters_.right_sides));
    y_dot_.resize(y.size());
    f(y, y_dot_, t);
    for (std::string trouble;;) {
      if (choice_.is_too_small(t)) give_up(system, t, y, trouble);
      const S tried = choice_.length(t, stop);
      S h = tried, moved = t;
      try {
        if (attempt(f, y, moved, h) == odeint::success) {
          choice_.accept(t, moved, stop, h);
          ++counters_.steps;
          return;
        }
        trouble.clear();
      } catch (const std::runtime_error& error) {
        trouble = error.what();
        h = tried / 4;
        forget();
      }
      choice_.reject(h < tried ? h : S(tried / 2));
      ++counters_.rejected_steps;
    }
  }
  void restart() {
    forget();
    choice_.restart();
    ++counters_.restarts;
  }
  /// A step to shorten was not taken after all.
  bool shorten() {
    forget();
    choice_.shorten();
    --counters_.steps;
    ++counters_.rejected_steps;
    return true;
  }
  const Counters& counters() const { return counters_; }

 private:
  template <class F>
  odeint::controlled_step_result attempt(const F& f, Flat<S>& y, S& t, S& h) {
    // the derivative at hand is that of y as it was projected
    if constexpr (requires { controlled_.try_step(f, y, y_dot_, t, h); })
      return controlled_.try_step(f, y, y_dot_, t, h);
    else
      return controlled_.try_step(f, y, t, h);
  }

  void forget() {
    if constexpr (requires { controlled_.reset(); }) controlled_.reset();
  }

  Controlled controlled_;
  int order_;
  Tolerances tolerances_;
  StepChoice<S> choice_;
  Flat<S> y_dot_;
  Counters counters_;
};

/// Steps of the grid's length.
template <class S, class Stepper>
class GivenSteps {
 public:
  template <FirstOrderSystem System>
  void step(System& system, S& t, Flat<S>& y, const S& stop) {
    using std::abs;
    const S h = stop - t;
    if (remembers_a_step || abs(h - last_) > S(1e-9) * last_) forget();
    last_ = h;
    stepper_.do_step(RightSide<System>{system, counters_.right_sides}, y, t, h);
    if (!y.allFinite())
      throw IntegrationError(fmt::format("at t = {}: the motion is not finite any more; take smaller steps",
                                         static_cast<double>(stop)));
    t = stop;
    ++counters_.steps;
  }
  void restart() {
    forget();
    ++counters_.restarts;
  }
  bool shorten() { return false; }
  const Counters& counters() const { return counters_; }

 private:
  /// Its last stage would be the next step's first, but y was projected since.
  static constexpr bool remembers_a_step =
      std::is_same_v<typename Stepper::stepper_category, odeint::explicit_error_stepper_fsal_tag>;

  void forget() {
    if constexpr (requires { stepper_.reset(); }) stepper_.reset();
    last_ = S(0);
  }

  Stepper stepper_;
  S last_{0};
  Counters counters_;
};

}  // namespace trivium::integrators
