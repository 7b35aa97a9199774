#pragma once
/// The laws of a system: the second half of the contract, which C++ types cannot express. Authors of a model
/// run `broken_laws` at a state; it returns the laws that do not hold. A ConstrainedSystem is tested for all
/// laws, another FirstOrderSystem for those of state_laws.hpp.
///
/// Most laws here allow 1e6 machine epsilons, two digits more than those of state_laws.hpp: they compare
/// solutions of linear systems, which the condition number makes less accurate, or sums in which large terms
/// cancel. Smaller bounds would reject a correct model at an ill-conditioned state; larger ones hide the loss
/// of a small term.

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "integrators/contract/constrained_system.hpp"
#include "integrators/contract/state_laws.hpp"

namespace trivium::integrators {

namespace detail {

/// Evaluates all laws at one state and lists those that do not hold.
template <ConstrainedSystem System>
class SystemLaws : StateLaws<System> {
 public:
  using Base = StateLaws<System>;
  using typename Base::S, typename Base::Y;
  using Evaluation = typename System::Evaluation;
  using Factors = typename System::Factors;
  using Base::Base;

  std::vector<BrokenLaw> broken() {
    Base::broken();
    violations();
    accelerations();
    rows();
    linear_systems();
    springs();
    internal_rows();
    values();
    return broken_;
  }

 private:
  using Base::broken_, Base::equal, Base::nearby, Base::nq_, Base::numbers, Base::nv_, Base::require,
      Base::system_, Base::t_, Base::v_, Base::with_velocity, Base::y_;

  Y rows_at(const S& t, const Y& y, bool of_velocities) {
    Evaluation at;
    system_.evaluate(t, y, at);
    Y values;
    if (of_velocities)
      system_.velocity_rows(at, values);
    else
      system_.position_rows(at, values);
    return values;
  }

  /// At a state that violates the constraints: both ways to measure a violation agree, and neither is 0.
  void violations() {
    const Y off = nearby(15);
    Evaluation at;
    Y values;
    system_.evaluate(t_, off, at);
    const auto measured = [&](const char* law, const Violation<S>& of_state, const Violation<S>& of_rows) {
      equal(law, Y{{of_state.size, of_state.relative}}, Y{{of_rows.size, of_rows.relative}}, 1e6);
      require("a violated row gives a violation above 0",
              values.isZero(S(0)) || (of_rows.size > S(0) && of_rows.relative > S(0)));
    };
    const Violation<S> of_positions = system_.position_rows(at, values);
    measured("position_violation and position_rows return the same violation",
             system_.position_violation(t_, off), of_positions);
    const Violation<S> of_velocities = system_.velocity_rows(at, values);
    measured("velocity_violation and velocity_rows return the same violation",
             system_.velocity_violation(t_, off), of_velocities);
  }
  void accelerations() {
    Y v_dot, lambda, force, left, internal = Y::Zero(nv_), y_dot;
    Evaluation at;
    system_.accelerations(t_, y_, v_dot, lambda);
    system_.evaluate(t_, y_, at);
    system_.inertia_force(at, v_dot, force);
    const Y imbalance = Y::Constant(1, S(system_.residual(at, force, lambda, left)));
    equal("accelerations: v' and lambda make the residual zero", imbalance, Y::Zero(1), 1e6);
    system_.inertia_force(at, v_dot + (1 + v_dot.norm()) * numbers(nv_, 17), force);
    // The imbalance is relative to the forces. Another v' gives one of the order of 1, and 1e-6 is far below
    // this and far above rounding.
    require("accelerations: the residual of another v' is not zero",
            system_.residual(at, force, lambda, left) > S(1e-6));
    system_.internal_residual(at, v_dot, internal);
    equal("accelerations: v' makes the residual of the internal rows zero", internal / (1 + v_.squaredNorm()),
          Y::Zero(nv_));
    system_.derivative(t_, y_, y_dot);
    equal("accelerations and derivative return the same v'", v_dot, y_dot.segment(nq_, nv_), 1e6);
    if (y_.size() > nq_ + nv_)
      equal("work_rate is the last entry of derivative", Y::Constant(1, S(system_.work_rate(at, lambda))),
            y_dot.tail(1), 1e6);
    // at rest there are no gyroscopic terms
    Factors factors;
    Y applied, reduced;
    system_.evaluate(t_, with_velocity(Y::Zero(nv_)), at);
    system_.residual(at, Y::Zero(nv_), Y::Zero(system_.multipliers()), left);
    system_.applied_force(at, applied);
    system_.factor(at, {}, factors);
    system_.reduce(factors, applied, reduced);
    equal("at rest and with v' = 0 the residual is the reduced applied force", reduced, left, 1e6);
  }
  void rows() {
    // Central differences along the motion. u here is the machine epsilon. With a step of about u^(1/3) the
    // truncation error (h^2) and the rounding error (u / h) are both of the order of u^(2/3). The factor 1e3
    // allows for third derivatives and values above 1. A larger one would hide errors.
    using std::cbrt;
    const double u = static_cast<double>(std::numeric_limits<S>::epsilon());
    const S h(cbrt(u) / (1 + static_cast<double>(S(v_.norm()))));
    Y ahead = y_, behind = y_;
    system_.displace(y_, h * v_, ahead);
    system_.displace(y_, -h * v_, behind);
    const Y slope = (rows_at(t_ + h, ahead, false) - rows_at(t_ - h, behind, false)) / (2 * h);
    const Y phi_dot = rows_at(t_, y_, true);
    equal("velocity_rows are the time derivative of position_rows", slope / (1 + v_.squaredNorm()),
          phi_dot / (1 + v_.squaredNorm()), 1e3 * cbrt(u * u) / u);
  }
  void linear_systems() {
    Evaluation at;
    Factors factors;
    system_.evaluate(t_, y_, at);
    // right side that the rows can meet even if some are redundant: the change of Phi_q v by a change of v
    const Y none = Y::Zero(nv_), no_lambda = Y::Zero(system_.multipliers());
    const Y phi_dot = rows_at(t_, y_, true);
    const Y rows = rows_at(t_, with_velocity(v_ + numbers(nv_, 2)), true) - phi_dot;
    Y left, force, alone, together, x = none, mu = no_lambda;
    system_.residual(at, none, no_lambda, alone);
    system_.factor(at, {}, factors);
    system_.reduce(factors, numbers(nv_, 3), left);
    system_.solve(factors, at, left, rows, x, mu);
    Evaluation again;
    system_.evaluate(t_, y_, again);
    system_.inertia_force(again, x, force);
    system_.residual(again, force, mu, together);
    equal("solve satisfies M x + Phi_q^T mu = left", alone - together, left, 1e6);
    equal("solve satisfies Phi_q x = rows", rows_at(t_, with_velocity(v_ + x), true) - phi_dot, rows, 1e6);
    Y same;
    system_.inertia_force(factors, x, same);
    equal("inertia_force is the same for factors and evaluation", same, force);
    Y x_slack = none, mu_slack = no_lambda, stretch, stiffness, damping;
    system_.spring_constants(stiffness, damping);
    require("spring_constants returns one stiffness and one damping per spring",
            stiffness.size() == system_.springs() && damping.size() == system_.springs());
    system_.solve(factors, at, left, rows, Y::Zero(system_.springs()), x_slack, mu_slack, stretch);
    equal("solve with slack 0 returns the solution without slack", x_slack, x);
  }
  /// Let a and b be solutions, or the same one, with right side 0 for the rows. Multiplying the equations of
  /// b by x_a gives x_a . force = x_a . M x_b + sum over springs of resistance * stretch_a * (stretch_b -
  /// slack_b).
  void springs() {
    const S h(0.01);
    const Shares<S> shares{h * h / 4, h / 2};
    const Y no_rows = Y::Zero(system_.multipliers()), force = numbers(nv_, 9);
    Evaluation at;
    Factors factors;
    Y left, stiffness, damping, inertia_force;
    system_.evaluate(t_, y_, at);
    system_.factor(at, shares, factors);
    system_.reduce(factors, force, left);
    system_.spring_constants(stiffness, damping);
    const Y resistance = shares.velocity * damping + shares.position * stiffness;
    struct Solution {
      Y slack, x, stretch;
    };
    std::array<Solution, 2> solution;
    for (int k = 0; k < 2; ++k) {
      Solution& one = solution[k];
      Y mu = no_rows;
      one.slack = S(k) * numbers(system_.springs(), 10);
      one.x = Y::Zero(nv_);
      system_.solve(factors, at, left, no_rows, one.slack, one.x, mu, one.stretch);
      if (one.stretch.size() == 0) one.stretch = one.slack;  // the model has no springs
    }
    for (const Solution& a : solution)
      for (const Solution& b : solution) {
        system_.inertia_force(factors, b.x, inertia_force);
        const S of_inertia = a.x.dot(inertia_force),
                of_springs = a.stretch.dot(resistance.cwiseProduct(b.stretch - b.slack)),
                done = a.x.dot(force);
        equal("a spring resists (stretch - slack) with its damping and stiffness, weighted by the shares",
              Y::Constant(1, S(of_inertia + of_springs)), Y::Constant(1, done), 1e6);
      }
  }
  void internal_rows() {
    const S share(0.3);
    Y off = y_, v_dot = numbers(nv_, 11), moved_by;
    const Y given = v_dot;
    system_.displace(y_, S(0.02) * numbers(nv_, 12), off);
    Y there = off;
    const bool has_rows = system_.normalise_step(share, there, v_dot);
    if (has_rows) {
      system_.displacement(off, there, moved_by);
      equal("normalise_step moves positions by share times the change of v'", moved_by,
            share * (v_dot - given));
    } else {
      equal("without internal rows normalise_step does not change the state", there, off, 0);
      equal("without internal rows normalise_step does not change v'", v_dot, given, 0);
    }
    off = with_velocity(v_ + S(0.1) * numbers(nv_, 13));
    v_dot = given;
    system_.normalise_step_velocity(share, off, v_dot);
    off.segment(nq_, nv_) += share * (v_dot - given);
    there.head(nq_ + nv_) << there.head(nq_), off.segment(nq_, nv_);
    Y normalised = off;
    system_.normalise(normalised);
    equal("normalise_step_velocity: the velocities satisfy the internal rows", normalised, off);
    normalised = there;
    system_.normalise(normalised);
    equal("normalise_step: the positions satisfy the internal rows", normalised.head(nq_), there.head(nq_));
    Evaluation at;
    Y left = Y::Zero(nv_), nothing = left, x = left;
    system_.evaluate(t_, y_, at);
    system_.internal_residual(at, given, left);
    system_.solve_internal_rows(at, left, x);
    system_.internal_residual(at, given + x, nothing);
    equal("solve_internal_rows makes the residual of the internal rows zero",
          nothing / (1 + v_.squaredNorm()), Y::Zero(nv_));
  }
  /// The results for an evaluation do not depend on evaluations made later.
  void values() {
    Evaluation at, other;
    Y away = with_velocity(-v_), before, after;
    system_.displace(y_, S(0.01) * numbers(nv_, 4), away);
    system_.evaluate(t_, y_, at);
    system_.residual(at, numbers(nv_, 5), numbers(system_.multipliers(), 6), before);
    system_.evaluate(t_, away, other);
    system_.position_rows(other, after);
    system_.residual(at, numbers(nv_, 5), numbers(system_.multipliers(), 6), after);
    equal("an evaluation does not change when another state is evaluated", after, before, 1);
  }
};

}  // namespace detail

/// Returns the laws that do not hold at (t, y), a state that must meet the constraints.
template <FirstOrderSystem System>
std::vector<BrokenLaw> broken_laws(System& system, const typename System::Scalar& t,
                                   const StateVector<typename System::Scalar>& y) {
  if constexpr (ConstrainedSystem<System>)
    return detail::SystemLaws<System>(system, t, y).broken();
  else
    return detail::StateLaws<System>(system, t, y).broken();
}

}  // namespace trivium::integrators
