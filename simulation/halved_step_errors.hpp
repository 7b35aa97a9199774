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
        rho_(sums_.bodies()),
        rough_(rho_),
        largest_(rho_),
        growth_(rho_.size(), {S(far_larger), S(far_larger)}),
        compared_(rho_.size()) {}

  /// Adds the step from `before` that ended at (t, y), where `bodies` are those of y. `is_new`: the motion or
  /// its charts began anew since the last state.
  void step(const S& before, const S& t, const StateVector& y, bool is_new, const Bodies& bodies) {
    sums_.see(bodies);
    first_order().derivative(t, y, rate_);
    if (std::exchange(has_begun_, true)) {
      sums_.step();
      if (!is_new) estimate(before, t, y, bodies);
    }
    before_ = y;
    rate_before_ = rate_;
  }

  LocalErrorSums sums(const std::vector<double>& least) const {
    std::vector<std::pair<double, double>> factors;
    for (const auto& [error, rough] : compared_) {
      const auto ratio = [](const S& x, const S& y) { return y > S(0) ? static_cast<double>(S(x / y)) : 0; };
      factors.emplace_back(ratio(error.first, rough.first), ratio(error.second, rough.second));
    }
    LocalErrorSums sums = sums_.sums(least, factors);
    if (has_failed_ && taken_ == 0) sums.steps = 0;
    return sums;
  }

 private:
  FirstOrderEquations<F>& first_order() { return equations_.first_order(); }

  static constexpr double far_larger = 4;  ///< growth of a power of rho that changes the sums
  using Pair = std::pair<S, S>;            ///< of positions [m] and of velocities [m/s]

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
      rho_[b] = {on_displacements_ ? size(b, Layout::of(way_, b), rounded)
                                   : size(b, layout.place(remainder_, b), rounded),
                 size(b, layout.rate(remainder_, b), layout.rate(rounded_, b))};
      rough_[b] = {raised(rho_[b].first), raised(rho_[b].second)};
    }
    take_if_due(before, t, y, bodies);
    sums_.add([&](int b) {
      return Pair(std::min(rough_[b].first, S(far_larger * largest_[b].first)),
                  std::min(rough_[b].second, S(far_larger * largest_[b].second)));
    });
  }
  void take_if_due(const S& before, const S& t, const StateVector& y, const Bodies& bodies) {
    if (!is_due()) return;
    met_ = before_;
    if (halved_(before, t, met_)) {
      ++taken_;
      bodies_at(first_order(), t, met_, in_halves_);
      for (int b = 0; b < sums_.bodies(); ++b) compare(b, difference(b, bodies[b], in_halves_[b]));
    } else {
      has_failed_ = true;
    }
    first_order().solved(t, y);  // the equations stand at the accepted state again
  }
  /// Enters the errors of body b. Errors above rho come from halves that end at a singular position.
  void compare(int b, const Pair& error) {
    const auto enter = [](const S& found, const S& rho, const S& rough, const S& scale, S& errors, S& roughs,
                          S& growth) {
      if (found > 10 * rho) return;
      errors += found;
      roughs += rough;
      // errors that are rounding need not be followed before they can be more
      growth = std::max(S(far_larger), found > S(0) ? S(S(1e-12) * scale / found) : S(far_larger));
    };
    const Pair scale = sums_.scale(b);
    auto& [errors, roughs] = compared_[b];
    enter(error.first, rho_[b].first, rough_[b].first, scale.first, errors.first, roughs.first,
          growth_[b].first);
    enter(error.second, rho_[b].second, rough_[b].second, scale.second, errors.second, roughs.second,
          growth_[b].second);
  }
  /// The size of a body's part (r, q) or (r', q'); 0 if it is rounding.
  S size(int b, const auto& part, const auto& rounded) const {
    const auto of = [&](const auto& x) {
      return S(x.template head<3>().norm() + sums_.reach(b) * x.tail(x.size() - 3).norm());
    };
    const S rho = of(part);
    return rho > of(rounded) ? rho : S(0);
  }
  S raised(const S& rho) const {
    using std::pow;
    return rho > S(0) ? S(pow(rho, power_)) : S(0);
  }

  /// The sums are decided where errors are largest: a step is due if the errors of a body are far larger than
  /// in all steps taken so far, which happens a few times, and otherwise now and then, the sooner the larger
  /// its errors are. Both as long as the halves cost less than a twentieth of the run, or errors have become
  /// larger by decades.
  bool is_due() {
    constexpr long few = 20, wait = 120;  // steps
    constexpr double by_decades = 1000;
    const long spent = halved_.counters().right_sides, all = method_.counters().right_sides,
               waited = method_.counters().steps - last_;
    const bool may_try = taken_ < few || 40 * spent < all, may_repeat = 60 * spent < all;
    const double nearly = std::scalbln(0.5, waited / wait);
    bool is = false;
    const auto compare = [&](const S& rough, const S& largest, const S& growth) {
      is = is || (rough > growth * largest && (may_try || rough > by_decades * largest)) ||
           (may_repeat && waited >= wait && rough > S(0) && nearly * rough >= largest);
    };
    for (std::size_t b = 0; b < rough_.size(); ++b) {
      compare(rough_[b].first, largest_[b].first, growth_[b].first);
      compare(rough_[b].second, largest_[b].second, growth_[b].second);
    }
    if (!is) return false;
    for (std::size_t b = 0; b < rough_.size(); ++b) {
      raise(largest_[b].first, rough_[b].first);
      raise(largest_[b].second, rough_[b].second);
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
  ErrorSums<S> sums_;                            ///< of powers of rho
  std::vector<Pair> rho_, rough_, largest_;      ///< rho and its power in this step; largest in those taken
  std::vector<Pair> growth_;                     ///< of the power of rho, after which a step is due
  std::vector<std::pair<Pair, Pair>> compared_;  ///< sums over the steps taken: of errors, of powers of rho
  StateVector before_, rate_before_, rate_, remainder_, rounded_, met_, way_, way_rate_;
  Bodies in_halves_;
  long taken_ = 0, last_ = 0;
  bool has_begun_ = false, has_failed_ = false;
};

}  // namespace trivium
