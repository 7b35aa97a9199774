#pragma once
/// Newton's method for the equations of one implicit step, with a matrix made once a step as a rule and
/// Anderson's acceleration for the rest. Here is decided when the equations count as solved, when a matrix is
/// made anew, and that the iteration diverges: where residuals fail to halve, by matrices made there, five
/// times, or after forty iterations. The methods that use it take given steps, so that this ends the run.

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>

#include "integrators/contract/constrained_system.hpp"
#include "integrators/contract/errors.hpp"
#include "integrators/contract/method.hpp"
#include "integrators/contract/tolerances.hpp"
#include "integrators/implicit/anderson.hpp"

namespace trivium::integrators {

/// When a step's equations count as solved: their imbalance, beside the forces at work. Constraints are met
/// to rounding always, as an error of theirs costs lambda that error over h^2.
struct NewtonOptions {
  double tolerance = 1e-10;
  bool is_full = false;  ///< a matrix for every iteration; else one for every step, and more where needed
};

/// How far q and v of a step move with v'.
template <class S>
struct Shares {
  S position, velocity;
};

/// The unknowns of a step, which begin as predicted. On the stabilised index 2, `shift` moves positions onto
/// their constraints, and v' meets those of velocities; on index 3 it is empty and v' meets positions.
template <class S>
struct StepUnknowns {
  StateVector<S> v_dot, lambda, shift;
};

/// Says which row is not met, or that forces do not balance, by what was evaluated last.
template <ConstrainedSystem System>
[[noreturn]] void throw_not_converged(System& system, const typename System::Scalar& t) {
  using S = typename System::Scalar;
  constexpr double met =
      1e-8;  // half of a double's digits; what does not converge is far above or at rounding
  const bool of_rows = !(system.relative_row_violation() <= S(met));
  throw IntegrationError(fmt::format("at t = {}: Newton's method does not converge: {}; take smaller steps",
                                     static_cast<double>(t),
                                     of_rows ? fmt::format("row \"{}\" is not met", system.least_met_row())
                                             : std::string("forces do not balance")));
}

template <ConstrainedSystem System>
class Newton {
 public:
  using S = typename System::Scalar;

  explicit Newton(const NewtonOptions& options) : options_(options) {}

  /// `place(x, y)` moves y to where the unknowns lead; `force(y, v_dot, f)` is what stands in the place of M
  /// v', which it is unless given. Throws an IntegrationError that names the row, or says that forces do not
  /// balance.
  template <class Place>
  void operator()(System& system, const S& t, const Shares<S>& shares, const Place& place, StateVector<S>& y,
                  StepUnknowns<S>& x, Counters& counters) {
    (*this)(system, t, shares, place, y, x, counters,
            [&](const StateVector<S>& at, const StateVector<S>& v_dot, StateVector<S>& force) {
              system.inertia_force(at, v_dot, force);
            });
  }
  template <class Place, class Force>
  void operator()(System& system, const S& t, const Shares<S>& shares, const Place& place, StateVector<S>& y,
                  StepUnknowns<S>& x, Counters& counters, const Force& force) {
    const bool is_stabilised = x.shift.size() > 0;
    const Eigen::Index nv = x.v_dot.size(), nc = x.lambda.size();
    bool is_fresh = false;
    anderson_.clear();
    S before = std::numeric_limits<S>::max();
    for (int k = 0, rises = 0; k < most_iterations && rises < most_rises; ++k) {
      place(x, y);
      if (system.normalise_step(is_stabilised ? S(1) : shares.position, y,
                                is_stabilised ? x.shift : x.v_dot)) {
        if (is_stabilised) system.normalise_step_velocity(shares.velocity, y, x.v_dot);
        place(x, y);
      }
      if (!x.v_dot.allFinite() || !x.lambda.allFinite()) break;
      force(y, x.v_dot, force_);
      const S imbalance = system.residual(t, y, force_, x.lambda);
      ++counters.right_sides;
      S violation = system.relative_row_violation();
      if (is_stabilised) violation = std::max(violation, S(system.velocity_rows()));
      if (imbalance <= enough() && violation <= rounding<S>()) return;
      // what falls no more by a matrix made there is rounding, or no solution
      const S now = imbalance / enough() + violation / rounding<S>();
      const bool falls = now <= before / 2;
      if (!falls && is_fresh) {
        if (imbalance <= S(1e3) * enough() && violation <= S(1e3) * rounding<S>()) return;
        ++rises;
      }
      before = now;
      is_fresh = k == 0 || options_.is_full || (!falls && !is_fresh);
      if (is_fresh) {
        system.factor(shares.velocity, shares.position);
        if (!options_.is_full) anderson_.clear();
      }
      change_.setZero(nv + nc + x.shift.size());
      if (is_stabilised) {
        shift_change_.setZero(nv);
        system.project(S(shares.position / shares.velocity), shift_change_);
        change_.tail(nv) = shift_change_;
      }
      v_change_.setZero(nv);
      lambda_change_.setZero(nc);
      system.newton(is_stabilised ? shares.velocity : shares.position, v_change_, lambda_change_);
      change_.head(nv) = v_change_;
      change_.segment(nv, nc) = lambda_change_;
      const StateVector<S>& step = anderson_.step(change_, nv);
      x.v_dot += step.head(nv);
      x.lambda += step.segment(nv, nc);
      if (is_stabilised) x.shift += step.tail(nv);
      ++counters.iterations;
    }
    throw_not_converged(system, t);
  }

 private:
  static constexpr int most_iterations = 40, most_rises = 5;

  S enough() const { return std::max(S(options_.tolerance), rounding<S>()); }

  NewtonOptions options_;
  Anderson<S> anderson_;
  StateVector<S> force_, change_, v_change_, lambda_change_, shift_change_;
};

}  // namespace trivium::integrators
