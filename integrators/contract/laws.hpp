#pragma once
/// The laws of a ConstrainedSystem, for whoever writes a model: the second half of the contract, which types
/// cannot say. `broken_laws` tries them at a state and names those that do not hold.

#include <cmath>
#include <limits>
#include <vector>

#include "base/broken_law.hpp"
#include "integrators/contract/constrained_system.hpp"

namespace trivium::integrators {

namespace detail {

template <ConstrainedSystem System>
class SystemLaws {
 public:
  using S = typename System::Scalar;
  using Y = StateVector<S>;
  using Evaluation = typename System::Evaluation;
  using Factors = typename System::Factors;

  SystemLaws(System& system, const S& t, const Y& y)
      : system_(system),
        t_(t),
        y_(y),
        nq_(system.position_size()),
        nv_(system.velocity_size()),
        v_(y.segment(nq_, nv_)) {}

  std::vector<BrokenLaw> broken() {
    displacements();
    corrections();
    accelerations();
    rows();
    linear_systems();
    values();
    return broken_;
  }

 private:
  /// What differs is rounding, of numbers as large as these.
  void equal(const char* law, const Y& a, const Y& b, double digits_lost = 1e4) {
    const bool same_size = a.size() == b.size();
    const double size = 1 + (same_size ? static_cast<double>(S(a.norm() + b.norm())) : 0.0);
    const double off = same_size ? static_cast<double>(S((a - b).norm())) / size : 1.0;
    const double bound = digits_lost * static_cast<double>(std::numeric_limits<S>::epsilon());
    if (!(off <= bound)) broken_.push_back({law, off, bound});
  }
  /// Fixed numbers without a pattern, of size 1.
  static Y numbers(int size, int seed) {
    return Y::NullaryExpr(size, [seed](Eigen::Index k) {
      return S(std::sin(static_cast<double>(7 * k + 13 * seed + 1) * 1.7));
    });
  }
  Y with_velocity(const Y& v) const {
    Y y = y_;
    y.segment(nq_, nv_) = v;
    return y;
  }
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

  void displacements() {
    const Y by = S(0.1) * numbers(nv_, 1), none = Y::Zero(nv_);
    Y to = y_, found, rate, y_dot;
    system_.displace(y_, by, to);
    system_.displacement(y_, to, found);
    equal("a displacement leads from one state to the other", found, by);
    system_.displacement_rate(none, v_, rate);
    equal("a displacement begins to grow as v", rate, v_);
    system_.position_rate(y_, v_, rate);
    system_.derivative(t_, y_, y_dot);
    equal("positions grow as y' says", rate, y_dot.head(nq_));
  }
  /// Of a Newton iteration from nearby: what is left is of the square.
  void corrections() {
    Y off = y_;
    system_.displace(y_, S(1e-3) * numbers(nv_, 7), off);
    off.segment(nq_, nv_) += S(1e-3) * (1 + v_.norm()) * numbers(nv_, 8);
    system_.normalise(off);
    const auto falls = [&](const char* law, const auto& violation, const auto& correct) {
      const double before = static_cast<double>(violation().size);
      correct();
      system_.normalise(off);
      const double after = static_cast<double>(violation().size), bound = before / 10 + 1e-12;
      if (!(after <= bound)) broken_.push_back({law, after, bound});
    };
    falls(
        "a correction leads positions back", [&] { return system_.position_violation(t_, off); },
        [&] { system_.correct_positions(t_, off, true); });
    falls(
        "a correction leads velocities back", [&] { return system_.velocity_violation(t_, off); },
        [&] { system_.correct_velocities(t_, off, true); });
  }
  void accelerations() {
    Y v_dot, lambda, force, left, internal = Y::Zero(nv_), y_dot;
    Evaluation at;
    system_.accelerations(t_, y_, v_dot, lambda);
    system_.evaluate(t_, y_, at);
    system_.inertia_force(at, v_dot, force);
    const Y imbalance = Y::Constant(1, S(system_.residual(at, force, lambda, left)));
    equal("accelerations and multipliers of index 1 leave no imbalance", imbalance, Y::Zero(1), 1e6);
    system_.internal_residual(at, v_dot, internal);
    equal("accelerations of index 1 leave nothing of internal rows", internal / (1 + v_.squaredNorm()),
          Y::Zero(nv_));
    system_.derivative(t_, y_, y_dot);
    equal("accelerations of index 1 are those of y'", v_dot, y_dot.segment(nq_, nv_), 1e6);
  }
  void rows() {
    // by the motion's own displacement, from both sides; what is left is of the square of the step
    using std::cbrt;
    const double u = static_cast<double>(std::numeric_limits<S>::epsilon());
    const S h(cbrt(u) / (1 + static_cast<double>(S(v_.norm()))));
    Y ahead = y_, behind = y_;
    system_.displace(y_, h * v_, ahead);
    system_.displace(y_, -h * v_, behind);
    const Y slope = (rows_at(t_ + h, ahead, false) - rows_at(t_ - h, behind, false)) / (2 * h);
    const Y phi_dot = rows_at(t_, y_, true);
    equal("velocity rows are the rate of position rows", slope / (1 + v_.squaredNorm()),
          phi_dot / (1 + v_.squaredNorm()), 1e3 * cbrt(u * u) / u);
  }
  void linear_systems() {
    Evaluation at;
    Factors factors;
    system_.evaluate(t_, y_, at);
    // rows that can be met: what a change of v does to them
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
    equal("a solution balances: M x + Phi_q^T mu is the left side", alone - together, left, 1e6);
    equal("a solution meets its rows: Phi_q x", rows_at(t_, with_velocity(v_ + x), true) - phi_dot, rows,
          1e6);
    Y same;
    system_.inertia_force(factors, x, same);
    equal("M is the same in factors", same, force);
    Y x_slack = none, mu_slack = no_lambda, stretch, stiffness, damping;
    system_.spring_constants(stiffness, damping);
    equal("every spring has its constants", Y::Constant(2, S(system_.springs())),
          Y{{S(static_cast<double>(stiffness.size())), S(static_cast<double>(damping.size()))}});
    system_.solve(factors, at, left, rows, Y::Zero(system_.springs()), x_slack, mu_slack, stretch);
    equal("without slack springs are as in the plain solution", x_slack, x);
  }
  /// What is asked of an evaluation does not depend on what was evaluated after it.
  void values() {
    Evaluation at, other;
    Y away = with_velocity(-v_), before, after;
    system_.displace(y_, S(0.01) * numbers(nv_, 4), away);
    system_.evaluate(t_, y_, at);
    system_.residual(at, numbers(nv_, 5), numbers(system_.multipliers(), 6), before);
    system_.evaluate(t_, away, other);
    system_.position_rows(other, after);
    system_.residual(at, numbers(nv_, 5), numbers(system_.multipliers(), 6), after);
    equal("an evaluation stays as it was made", after, before, 1);
  }

  System& system_;
  const S t_;
  const Y y_;
  const int nq_, nv_;
  const Y v_;
  std::vector<BrokenLaw> broken_;
};

}  // namespace detail

/// The laws that do not hold at (t, y), which must meet the constraints.
template <ConstrainedSystem System>
std::vector<BrokenLaw> broken_laws(System& system, const typename System::Scalar& t,
                                   const StateVector<typename System::Scalar>& y) {
  return detail::SystemLaws<System>(system, t, y).broken();
}

}  // namespace trivium::integrators
