#pragma once
/// Explicit methods of Boost.Odeint for y' = f(t, y): Dormand-Prince 5(4), Fehlberg 7(8), Bulirsch-Stoer and
/// Adams-Bashforth-Moulton. They choose their steps; all but Bulirsch-Stoer also take given ones. With given
/// steps, methods that remember earlier steps restart when the step size changes.

#include <fmt/format.h>

#include <algorithm>
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
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

#include "integrators/quad.hpp"
#include "integrators/step_size_control.hpp"
#include "integrators/time_grid.hpp"

namespace trivium::integrators {

namespace odeint = boost::numeric::odeint;

/// Algebra for Odeint whose norm accepts class scalars such as Quad, and is infinite if an element is not
/// finite.
struct StateVectorAlgebra : odeint::range_algebra {
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

/// Dormand-Prince 5(4).
template <class S>
using DormandPrince5 = odeint::runge_kutta_dopri5<StateVector<S>, S, StateVector<S>, S, StateVectorAlgebra>;
/// Fehlberg 7(8).
template <class S>
using Fehlberg78 = odeint::runge_kutta_fehlberg78<StateVector<S>, S, StateVector<S>, S, StateVectorAlgebra>;
/// Bulirsch-Stoer as Odeint constructs it.
template <class S>
using OdeintBulirschStoer = odeint::bulirsch_stoer<StateVector<S>, S, StateVector<S>, S, StateVectorAlgebra>;

/// The private member of a class of Odeint that its constructor (1.74) leaves unwritten: the last step size,
/// which the first step compares with its own. An explicit instantiation may name private members.
template <class S>
struct LastStepSize;
/// In double.
template <>
struct LastStepSize<double> {
  friend double& last_step_size(LastStepSize, OdeintBulirschStoer<double>& of);
};
/// In Quad.
template <>
struct LastStepSize<Quad> {
  friend Quad& last_step_size(LastStepSize, OdeintBulirschStoer<Quad>& of);
};
/// Defines last_step_size by the private member.
template <class S, S OdeintBulirschStoer<S>::*member>
struct OpenLastStepSize {
  friend S& last_step_size(LastStepSize<S>, OdeintBulirschStoer<S>& of) { return of.*member; }
};
template struct OpenLastStepSize<double, &OdeintBulirschStoer<double>::m_dt_last>;
template struct OpenLastStepSize<Quad, &OdeintBulirschStoer<Quad>::m_dt_last>;

/// Bulirsch-Stoer that begins without a last step size.
template <class S>
struct BulirschStoer : OdeintBulirschStoer<S> {
  BulirschStoer(const S& atol, const S& rtol) : OdeintBulirschStoer<S>(atol, rtol) {
    last_step_size(LastStepSize<S>(), *this) = S(0);
  }
};
/// For given steps: predictor and corrector of 5 steps, started by Fehlberg 7(8).
template <class S>
using AdamsBashforthMoulton =
    odeint::adams_bashforth_moulton<5, StateVector<S>, S, StateVector<S>, S, StateVectorAlgebra,
                                    odeint::default_operations, odeint::initially_resizer, Fehlberg78<S>>;
/// For chosen steps: step size and order are chosen, orders up to 12. Odeint's constructor (1.74) leaves
/// coefficients unwritten that its first steps read. Copies of a static object have zeros there.
struct AdaptiveAdams
    : odeint::adaptive_adams_bashforth_moulton<12, StateVector<double>, double, StateVector<double>, double,
                                               StateVectorAlgebra> {
  AdaptiveAdams() : adaptive_adams_bashforth_moulton(zeros()) {}

 private:
  static const adaptive_adams_bashforth_moulton& zeros() {
    static const adaptive_adams_bashforth_moulton with_zeros;
    return with_zeros;
  }
};

/// Chooses the order of AdaptiveAdams for the next step: lower where a lower order has a smaller error,
/// higher where the next order has a far smaller error (Shampine and Gordon, Computer Solution of Ordinary
/// Differential Equations, 1975; the share 0.5 to 0.25 is Odeint's). Odeint's own rule also compares with an
/// error of the next order that was not computed in this step.
struct AdamsOrder {
  /// `errors` of the orders k - 2 to k + 1; `known` states precede this step, at most as many as the highest
  /// order.
  std::size_t adjust_order(std::size_t k, std::size_t known,
                           const boost::array<AdaptiveAdams::wrapped_state_type, 4>& errors) const {
    constexpr std::size_t highest = AdaptiveAdams::order_value;
    const auto size = [&](int n) { return StateVectorAlgebra::norm_inf(errors[n].m_v); };
    if (known < k) return k + 1;
    const double now = size(2);
    if (k == 2 && size(1) <= now / 2) return k - 1;
    if (k > 2 && size(0) < now && size(1) < now) return k - 1;
    if (k == highest || known == k) return k;  // Odeint has not computed errors[3]
    const double next = size(3);
    if (k > 1 && size(1) <= std::min(now, next)) return k - 1;
    return next < (0.5 - 0.25 * static_cast<double>(k) / highest) * now ? k + 1 : k;
  }
};
/// AdaptiveAdams with the step sizes of Odeint's controller H211PI and the orders of AdamsOrder.
using ControlledAdams = odeint::controlled_adams_bashforth_moulton<
    AdaptiveAdams,
    odeint::detail::pid_step_adjuster<StateVector<double>, double, StateVector<double>, double,
                                      StateVectorAlgebra, AdaptiveAdams::operations_type,
                                      odeint::detail::H211PI>,
    AdamsOrder>;

/// The right side f as Odeint calls it; counts the calls.
template <FirstOrderSystem System>
struct RightSide {
  using S = typename System::Scalar;
  System& system;
  long& calls;

  void operator()(const StateVector<S>& y, StateVector<S>& y_dot, const S& t) const {
    ++calls;
    system.derivative(t, y, y_dot);
  }
};

/// Chosen steps, by a controlled stepper of Odeint.
template <class S, class Controlled>
class ChosenSteps {
 public:
  ChosenSteps(Controlled controlled, int order, const Tolerances& tolerances)
      : controlled_(std::move(controlled)), order_(order), tolerances_(tolerances) {}

  template <FirstOrderSystem System>
  void step(System& system, S& t, StateVector<S>& y, const S& stop) {
    RightSide<System> f{system, counters_.right_sides};
    if (!step_size_.has_begun())
      step_size_.begin(first_step(system, t, y, order_, tolerances_, counters_.right_sides));
    y_dot_.resize(y.size());
    f(y, y_dot_, t);
    for (std::string trouble;;) {
      if (step_size_.is_too_small(t, stop)) give_up(static_cast<double>(t), trouble);
      const S tried = step_size_.length(t, stop);
      S h = tried, moved = t;
      try {
        if (attempt(f, y, moved, h) == odeint::success) {
          step_size_.accept(t, moved, stop, h);
          ++counters_.steps;
          return;
        }
        trouble.clear();
      } catch (const UsageError&) {
        throw;
      } catch (const std::runtime_error& error) {  // no error estimate: a quarter is tried
        trouble = error.what();
        h = tried / 4;
        forget();
      }
      // a controller that rejects a step without a smaller proposal must not try the same size for ever
      step_size_.reject(h < tried ? h : S(tried / 2));
      ++counters_.rejected_steps;
    }
  }
  void restart() {
    forget();
    step_size_.restart();
    ++counters_.restarts;
  }
  /// The last step was taken back: it no longer counts, and the next one is shorter.
  bool shorten() {
    forget();
    step_size_.shorten();
    --counters_.steps;
    ++counters_.rejected_steps;
    return true;
  }
  const Counters& counters() const { return counters_; }
  /// 30 tolerances: usual steps violate constraints by up to three. An embedded estimate does not see all
  /// stages: that of Fehlberg 7(8) consists of the first and the last two, and misses a singular position
  /// between them.
  S largest_drift() const { return S(30 * std::max(tolerances_.rtol, tolerances_.atol)); }

 private:
  template <class F>
  odeint::controlled_step_result attempt(const F& f, StateVector<S>& y, S& t, S& h) {
    // y_dot_ is the derivative at the projected y; a stepper that accepts no derivative computes its own
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
  StepSizeControl<S> step_size_;
  StateVector<S> y_dot_;
  Counters counters_;
};

/// Given steps.
template <class S, class Stepper>
class GivenSteps {
 public:
  template <FirstOrderSystem System>
  void step(System& system, S& t, StateVector<S>& y, const S& stop) {
    const S h = stop - t;
    if (remembers_a_step || !is_same_length(h, last_)) forget();
    last_ = h;
    stepper_.do_step(RightSide<System>{system, counters_.right_sides}, y, t, h);
    require_finite(y, stop);
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
  /// An FSAL stepper uses the derivative of its last stage again in the next step; y was projected since, so
  /// that the stepper must forget it.
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
