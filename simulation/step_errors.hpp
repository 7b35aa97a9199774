#pragma once
/// The errors that the given steps of a run commit. They are estimated by formulas over past states
/// (system/local_error.hpp). For orders above 5 these lack a factor, the ratio in a few steps that are taken
/// again in halves (halved_steps.hpp).

#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "base/raise.hpp"
#include "integrators/contract/any_method.hpp"
#include "mechanism/reach.hpp"
#include "simulation/halved_steps.hpp"
#include "simulation/system/constrained_equations.hpp"
#include "simulation/system/local_error.hpp"

namespace trivium {

/// Follows the accepted states of a run and sums the errors of its steps.
template <Formulation F>
class StepErrors {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;

  /// `order` of the method. `halved` takes steps in halves by the same method. The equations and the method
  /// must outlive this object.
  StepErrors(FirstOrderEquations<F>& equations, const integrators::AnyMethod<S>& method, int order,
             HalvedSteps<S> halved)
      : equations_(equations),
        method_(method),
        by_formula_(order, reaches(equations.mechanism()), components(equations)),
        compared_(equations.nb()) {
    if (order > LocalError<S>::highest_order) halved_.emplace(std::move(halved));
  }

  /// Adds the step that ended at an accepted state. `off` is the violation of velocities there.
  void step(const S& t, const StateVector& y, const integrators::Violation<S>& off) {
    if (has_begun_ && t == t_) return;  // an output at the end of a step
    has_begun_ = true;
    // where the motion or its chart began anew, the states before do not belong to it
    const long restarts = method_.counters().restarts;
    if (std::exchange(restarts_, restarts) != restarts) by_formula_.restart();
    const S before = std::exchange(t_, t);
    if (by_formula_.leaves_out()) return;
    if (add_state(t, y, S(t - before), off) && halved_) compare(before, t, y);
    if (halved_) before_ = y;
  }

  LocalErrorSums sums() const {
    std::vector<double> least;
    std::vector<std::pair<double, double>> factors;
    for (int b = 0; b < equations_.nb(); ++b) {
      least.push_back(least_speed(b));
      const auto& [of_halved, of_formula] = compared_[b];
      const auto ratio = [](const S& x, const S& y) { return y > S(0) ? static_cast<double>(S(x / y)) : 1; };
      factors.emplace_back(ratio(of_halved.first, of_formula.first),
                           ratio(of_halved.second, of_formula.second));
    }
    LocalErrorSums sums = by_formula_.sums().sums(least, factors);
    if (halved_ && !has_compared_) sums = {.body = sums.body};  // the factors are not known
    return sums;
  }

 private:
  using Bodies = std::vector<BodyInMotion<S>>;
  using Pair = std::pair<S, S>;  ///< errors of positions [m] and of velocities [m/s]

  static std::vector<int> components(FirstOrderEquations<F>& equations) {
    std::vector<int> component;
    for (int b = 0; b < equations.nb(); ++b) component.push_back(equations.measure().component_of(b));
    return component;
  }
  /// The speed that loads could give [m/s].
  double least_speed(int b) const { return static_cast<double>(equations_.measure().fastest_of(b)); }

  /// With index 3 the violation of velocities is of order h^2 and does not accumulate; the velocities are
  /// projected, so that only errors count that do. Returns whether the step was estimated.
  bool add_state(const S& t, const StateVector& y, const S& h, const integrators::Violation<S>& off) {
    const bool is_off = off.relative > 1000 * std::numeric_limits<S>::epsilon();
    met_ = y;
    if (is_off) equations_.correct_velocities(t, met_, false);
    bodies_at(t, y, reached_);
    for (int b = 0; is_off && b < equations_.nb(); ++b) {
      BodyState<F> state = equations_.state()[b];
      const auto& layout = equations_.layout();
      state.q = F::from_orientation(state.chart, layout.orientation(met_, b), layout.velocity(met_, b));
      reached_[b].v = layout.rate(met_, b).template head<3>();
      reached_[b].omega_bar = kinematics_of(state).omega_bar;
    }
    return by_formula_.add(reached_, h, is_off);
  }

  /// Compares the estimate of the step just added with that by halves, if it is due.
  void compare(const S& before, const S& t, const StateVector& y) {
    if (!halved_->is_due(by_formula_.last(), method_.counters().steps)) return;
    met_ = before_;
    const bool is_taken = (*halved_)(before, t, met_);
    if (is_taken) bodies_at(t, met_, in_halves_);
    bodies_at(t, y, reached_);  // the equations stand at the accepted state again
    if (!is_taken) return;
    has_compared_ = true;
    for (int b = 0; b < equations_.nb(); ++b) {
      const auto add = [](Pair& sum, const Pair& x) { sum = {sum.first + x.first, sum.second + x.second}; };
      add(compared_[b].first, difference(b));
      add(compared_[b].second, by_formula_.last()[b]);
    }
  }
  Pair difference(int b) const {
    const BodyInMotion<S>&one = reached_[b], &other = in_halves_[b];
    const Vector4<S> turn = multiply_parameters(conjugate_parameters(one.p), other.p);
    const S& reach = by_formula_.sums().reach(b);
    return {(one.r - other.r).norm() + 2 * reach * turn.template tail<3>().norm(),
            (one.v - other.v).norm() + reach * (one.omega_bar - other.omega_bar).norm()};
  }

  void bodies_at(const S& t, const StateVector& y, Bodies& bodies) {
    AccelerationSolver<F>& solver = equations_.solved(t, y);
    bodies.resize(equations_.nb());
    for (int b = 0; b < equations_.nb(); ++b) {
      const auto& body = solver.assembly().body()[b];
      bodies[b] = {body.r,           body.r_dot,
                   solver.r_ddot(b), euler_parameters(body.A),
                   body.omega_bar,   solver.omega_bar_dot(b)};
    }
  }

  FirstOrderEquations<F>& equations_;
  const integrators::AnyMethod<S>& method_;
  LocalError<S> by_formula_;
  std::optional<HalvedSteps<S>> halved_;
  std::vector<std::pair<Pair, Pair>> compared_;  ///< per body: sums by halves and by the formula
  Bodies reached_, in_halves_;
  StateVector met_, before_;
  S t_{0};
  long restarts_ = 0;
  bool has_begun_ = false, has_compared_ = false;
};

}  // namespace trivium
