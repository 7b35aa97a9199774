#pragma once
/// Local errors of methods of orders above 5, from a few steps that are taken again in halves. A rough figure
/// for every step tells which steps to take, and carries the result over to the other steps. With the
/// numbers y of the formulation it is the remainder of the trapezoidal rule,
///
///     rho = | y_n+1 - y_n - h (y'_n + y'_n+1) / 2 |,
///
/// of order h^3. (For methods on displacements y_n+1 - y_n is the displacement, and y' its rate, so that an
/// even rotation leaves no remainder.) It is large in the same steps as the error of a method of order p,
/// which goes about with a power of rho. The power (p + 1) / 2, above (p + 1) / 3, rather says too much where
/// rho grows. The result is carried over only up to four times the largest power of rho among the steps
/// taken: rounding, which goes with no such power, must not grow.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/raise.hpp"
#include "integrators/contract/any_method.hpp"
#include "simulation/halved_steps.hpp"
#include "simulation/system/constrained_equations.hpp"
#include "simulation/system/error_sums.hpp"

namespace trivium {

/// What the bodies do at an accepted state (t, y).
template <Formulation F, class S = typename F::Scalar>
void bodies_at(FirstOrderEquations<F>& equations, const S& t, const VectorX<S>& y,
               std::vector<BodyInMotion<S>>& bodies) {
  AccelerationSolver<F>& solver = equations.solved(t, y);
  bodies.resize(equations.nb());
  for (int b = 0; b < equations.nb(); ++b) {
    const auto& body = solver.assembly().body()[b];
    bodies[b] = {body.r,           body.r_dot,
                 solver.r_ddot(b), euler_parameters(body.A),
                 body.omega_bar,   solver.omega_bar_dot(b)};
  }
}

/// The errors of the positions, or of the velocities, of one body, known in the steps taken in halves.
template <class S>
class CarriedError {
 public:
  /// A step with this rho, of which `power` is the power.
  void step(const S& rho, const S& power) {
    rho_ = rho;
    power_ = power;
  }
  /// What the step adds to the sum.
  S power() const { return std::min(power_, S(far_larger * largest_)); }
  /// Whether the step says more of the sum than the steps taken so far. `may_try`: it need not be larger by
  /// decades.
  bool has_grown(bool may_try) const {
    constexpr double by_decades = 1000;
    return power_ > growth_ * largest_ && (may_try || power_ > by_decades * largest_);
  }
  /// Whether the step is as large as those taken, if it counts `times`-fold.
  bool is_large(double times) const { return power_ > S(0) && times * power_ >= largest_; }
  void take() { raise(largest_, power_); }
  /// Enters the error of the step. Errors above rho come from halves that end at a singular position. `scale`
  /// is the size of the quantity.
  void enter(const S& error, const S& scale) {
    if (error > 10 * rho_) return;
    errors_ += error;
    powers_ += power_;
    // errors that are rounding need not be followed before they can be more
    growth_ = std::max(S(far_larger), error > S(0) ? S(S(1e-12) * scale / error) : S(far_larger));
  }
  /// The error in a step, divided by the power of its rho.
  double factor() const { return powers_ > S(0) ? static_cast<double>(S(errors_ / powers_)) : 0; }

 private:
  static constexpr double far_larger = 4;  ///< growth of a power of rho that changes the sum
  S rho_{0}, power_{0};                    ///< in the last step
  S largest_{0}, errors_{0}, powers_{0};   ///< of the steps taken: largest power, sums
  S growth_{far_larger};                   ///< of the power of rho, after which a step is due
};

/// Sums the local errors of every body.
template <Formulation F>
class HalvedStepErrors {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;
  using Bodies = std::vector<BodyInMotion<S>>;

  /// `on_displacements`: the method works on displacements. The equations and the method must outlive this
  /// object.
  HalvedStepErrors(ConstrainedEquations<F>& equations, const integrators::AnyMethod<S>& method, int order,
                   bool on_displacements, HalvedSteps<S> halved, ErrorSums<S> sums)
      : equations_(equations),
        method_(method),
        on_displacements_(on_displacements),
        power_(S(order + 1) / 2),
        halved_(std::move(halved)),
        sums_(std::move(sums)),
        errors_(sums_.bodies()) {}

  /// The motion begins, or begins anew, at (t, y), where `bodies` are those of y.
  void begin(const S& t, const StateVector& y, const Bodies& bodies) {
    sums_.see(bodies);
    first_order().derivative(t, y, rate_before_);
    before_ = y;
  }
  /// Adds the step from `before` that ended at (t, y), where `bodies` are those of y. `in_other_charts`: the
  /// charts have changed since the last state.
  void step(const S& before, const S& t, const StateVector& y, bool in_other_charts, const Bodies& bodies) {
    sums_.see(bodies);
    first_order().derivative(t, y, rate_);
    sums_.step();
    if (!in_other_charts) estimate(before, t, y, bodies);
    before_ = y;
    rate_before_ = rate_;
  }

  LocalErrorSums sums(const std::vector<double>& least) {
    std::vector<std::pair<double, double>> factors;
    for (const auto& [position, velocity] : errors_)
      factors.emplace_back(position.factor(), velocity.factor());
    sums_.end_part();
    LocalErrorSums sums = sums_.sums(least, factors);
    if (has_failed_ && taken_ == 0) {
      sums.steps = 0;
      sums.unknown = 1;
    }
    return sums;
  }

 private:
  FirstOrderEquations<F>& first_order() { return equations_.first_order(); }

  using Pair = std::pair<S, S>;  ///< of positions [m] and of velocities [m/s]

  void estimate(const S& before, const S& t, const StateVector& y, const Bodies& bodies) {
    using Layout = StateLayout<F>;
    const S half = (t - before) / 2;
    remainder_ = y - before_ - half * (rate_ + rate_before_);
    rounded_ = 64 * std::numeric_limits<S>::epsilon() * (y.cwiseAbs() + half * rate_.cwiseAbs());
    const int nq = equations_.position_size(), nv = equations_.velocity_size();
    if (on_displacements_) {
      equations_.displacement(before_, y, way_);
      equations_.displacement_rate(way_, y.segment(nq, nv), way_rate_);
      way_ -= half * (before_.segment(nq, nv) + way_rate_);
    }
    const auto& layout = first_order().layout();
    for (int b = 0; b < sums_.bodies(); ++b) {
      const auto rounded = layout.place(rounded_, b);
      enter_step(errors_[b].first, on_displacements_ ? size(b, Layout::of(way_, b), rounded)
                                                     : size(b, layout.place(remainder_, b), rounded));
      enter_step(errors_[b].second, size(b, layout.rate(remainder_, b), layout.rate(rounded_, b)));
    }
    take_if_due(before, t, y, bodies);
    sums_.add([&](int b) { return Pair(errors_[b].first.power(), errors_[b].second.power()); });
  }
  void enter_step(CarriedError<S>& error, const S& rho) const {
    using std::pow;
    error.step(rho, rho > S(0) ? S(pow(rho, power_)) : S(0));
  }
  void take_if_due(const S& before, const S& t, const StateVector& y, const Bodies& bodies) {
    if (!is_due()) return;
    met_ = before_;
    if (halved_(before, t, met_)) {
      ++taken_;
      bodies_at(first_order(), t, met_, in_halves_);
      for (int b = 0; b < sums_.bodies(); ++b) {
        const auto [position, velocity] = difference(b, bodies[b], in_halves_[b]);
        const auto [extent, speed] = sums_.scale(b);
        errors_[b].first.enter(position, extent);
        errors_[b].second.enter(velocity, speed);
      }
    } else {
      has_failed_ = true;
    }
    first_order().solved(t, y);  // the equations stand at the accepted state again
  }
  /// The size of a body's part (r, q) or (r', q'); 0 if it is rounding.
  S size(int b, const auto& part, const auto& rounded) const {
    const auto of = [&](const auto& x) {
      return S(x.template head<3>().norm() + sums_.reach(b) * x.tail(x.size() - 3).norm());
    };
    const S rho = of(part);
    return rho > of(rounded) ? rho : S(0);
  }
  /// The sums are decided where errors are largest: a step is due if the errors of a body are far larger than
  /// in all steps taken so far, which happens a few times, and otherwise now and then, the sooner the larger
  /// its errors are. Both as long as the halves cost less than a twentieth of the run, or errors have become
  /// larger by decades.
  bool is_due() {
    constexpr long few = 20, wait = 120;  // steps
    const long spent = halved_.counters().right_sides, all = method_.counters().right_sides,
               waited = method_.counters().steps - last_;
    const bool may_try = taken_ < few || 40 * spent < all, may_repeat = 60 * spent < all;
    const double times = std::scalbln(0.5, waited / wait);
    const auto is_due = [&](const CarriedError<S>& error) {
      return error.has_grown(may_try) || (may_repeat && waited >= wait && error.is_large(times));
    };
    if (std::none_of(errors_.begin(), errors_.end(),
                     [&](const auto& body) { return is_due(body.first) || is_due(body.second); }))
      return false;
    for (auto& [position, velocity] : errors_) {
      position.take();
      velocity.take();
    }
    last_ = method_.counters().steps;
    return true;
  }

  Pair difference(int b, const BodyInMotion<S>& one, const BodyInMotion<S>& other) const {
    const Vector4<S> turn = multiply_parameters(conjugate_parameters(one.p), other.p);
    const S& reach = sums_.reach(b);
    return {(one.r - other.r).norm() + 2 * reach * turn.template tail<3>().norm(),
            (one.v - other.v).norm() + reach * (one.omega_bar - other.omega_bar).norm()};
  }

  ConstrainedEquations<F>& equations_;
  const integrators::AnyMethod<S>& method_;
  const bool on_displacements_;
  const S power_;
  HalvedSteps<S> halved_;
  ErrorSums<S> sums_;                                                ///< of powers of rho
  std::vector<std::pair<CarriedError<S>, CarriedError<S>>> errors_;  ///< of positions, of velocities
  StateVector before_, rate_before_, rate_, remainder_, rounded_, met_, way_, way_rate_;
  Bodies in_halves_;
  long taken_ = 0, last_ = 0;
  bool has_failed_ = false;
};

}  // namespace trivium
