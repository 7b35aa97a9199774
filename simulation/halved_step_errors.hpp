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
/// rho grows.

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
        rough_(sums_.bodies()),
        largest_(rough_),
        compared_(rough_.size()) {}

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
      rough_[b] = {on_displacements_ ? raised(b, Layout::of(way_, b), rounded)
                                     : raised(b, layout.place(remainder_, b), rounded),
                   raised(b, layout.rate(remainder_, b), layout.rate(rounded_, b))};
    }
    sums_.add([&](int b) { return rough_[b]; });
    if (!is_due()) return;
    met_ = before_;
    if (halved_(before, t, met_)) {
      ++taken_;
      bodies_at(first_order(), t, met_, in_halves_);
      for (int b = 0; b < sums_.bodies(); ++b) {
        add(compared_[b].first, difference(b, bodies[b], in_halves_[b]));
        add(compared_[b].second, rough_[b]);
      }
    } else {
      has_failed_ = true;
    }
    first_order().solved(t, y);  // the equations stand at the accepted state again
  }
  /// A power of the size of a body's part (r, q) or (r', q'); 0 if it is rounding.
  S raised(int b, const auto& part, const auto& rounded) const {
    const auto size = [&](const auto& x) {
      return S(x.template head<3>().norm() + sums_.reach(b) * x.tail(x.size() - 3).norm());
    };
    using std::pow;
    const S rho = size(part);
    return rho > size(rounded) ? S(pow(rho, power_)) : S(0);
  }
  static void add(Pair& sum, const Pair& x) { sum = {sum.first + x.first, sum.second + x.second}; }

  /// The sums are decided where errors are largest: a step is due if the errors of a body are far larger than
  /// in all steps taken so far, which happens a few times, and otherwise now and then, the sooner the larger
  /// its errors are. Both as long as the halves cost less than a twentieth of the run.
  bool is_due() {
    constexpr double far_larger = 4;
    constexpr long few = 20, wait = 120;  // steps
    const long spent = halved_.counters().right_sides, all = method_.counters().right_sides,
               waited = method_.counters().steps - last_;
    const bool may_try = taken_ < few || 40 * spent < all, may_repeat = 60 * spent < all;
    const double nearly = std::scalbln(0.5, waited / wait);
    bool is = false;
    const auto compare = [&](const S& rough, const S& largest) {
      is = is || (may_try && rough > far_larger * largest) ||
           (may_repeat && waited >= wait && rough > S(0) && nearly * rough >= largest);
    };
    for (std::size_t b = 0; b < rough_.size(); ++b) {
      compare(rough_[b].first, largest_[b].first);
      compare(rough_[b].second, largest_[b].second);
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
  std::vector<Pair> rough_, largest_;            ///< powers of rho: in this step; largest in the steps taken
  std::vector<std::pair<Pair, Pair>> compared_;  ///< sums over the steps taken: of errors, of powers of rho
  StateVector before_, rate_before_, rate_, remainder_, rounded_, met_, way_, way_rate_;
  Bodies in_halves_;
  long taken_ = 0, last_ = 0;
  bool has_begun_ = false, has_failed_ = false;
};

}  // namespace trivium
