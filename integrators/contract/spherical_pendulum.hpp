#pragma once
/// A one-page model: a particle of mass m on a sphere of radius l about the origin, under gravity -g e_z, in
/// Cartesian coordinates y = (r, r'). It has every function of a ConstrainedSystem, so that a method can be
/// tested without formulations, bodies or the structured solver:
///
///   m r'' + r lambda = -m g e_z,   Phi = (r . r - l^2) / 2 = 0
///
/// With r . r'' = -r' . r', lambda is (m r' . r' - m g z) / l^2 on the sphere.

#include <Eigen/Core>
#include <limits>
#include <stdexcept>
#include <string>

#include "integrators/contract/constrained_system.hpp"

namespace trivium::integrators {

/// The pendulum and its start. The numbers are in SI units.
template <class S>
class SphericalPendulum {
 public:
  using Scalar = S;
  using Vector = Eigen::Matrix<S, 3, 1>;
  using Y = StateVector<S>;

  S m{2}, g{10}, l{1};
  Vector r0{S(0.6), S(0), S(-0.8)}, v0{S(0), S(3), S(0)};

  // y' = f(t, y), and the corrections that lead back onto the sphere
  int size() const { return 6; }
  Y start() const { return joined(r0, v0); }
  void derivative(const S& t, const Y& y, Y& y_dot) const {
    Y v_dot, lambda;
    accelerations(t, y, v_dot, lambda);
    y_dot = joined(y.tail(3), v_dot);
  }
  Violation<S> position_violation(const S&, const Y& y) const { return of_positions(phi(y)); }
  Violation<S> velocity_violation(const S&, const Y& y) const { return of_velocities(phi_dot(y), v(y)); }
  std::string row_name(int) const { return "sphere"; }
  void correct_positions(const S&, Y& y, bool factor) { y.head(3) -= phi(y) * direction(y, factor); }
  void correct_velocities(const S&, Y& y, bool factor) { y.tail(3) -= phi_dot(y) * direction(y, factor); }
  void normalise(Y&) const {}
  bool projection_is_too_large(const Y&, const Y&, const Y&) const { return false; }
  S longest_step(const S&, const Y&) const { return std::numeric_limits<S>::max(); }
  bool accept_state(const S&, Y&) const { return false; }
  bool pass_discontinuity(const S&, const S&, Y&) const { return false; }
  std::string diagnose(const S&, const Y&, const S&) const { return {}; }
  std::string most_accelerated(const S&, const Y&) const { return {}; }

  // displacements: they are added to the positions
  int position_size() const { return 3; }
  int velocity_size() const { return 3; }
  void displace(const Y& from, const Y& by, Y& to) const { to.head(3) = from.head(3) + by; }
  void displacement(const Y& from, const Y& to, Y& by) const { by = to.head(3) - from.head(3); }
  void displacement_rate(const Y&, const Y& velocity, Y& rate) const { rate = velocity; }
  void position_rate(const Y&, const Y& velocity, Y& rate) const { rate = velocity; }
  void position_sizes(const Y& y, Y& sizes) const { sizes.setConstant(3, r(y).norm()); }

  // the equations of motion at a state
  /// Position r [m] and velocity v [m/s] of the particle.
  struct Evaluation {
    Vector r, v;
    mutable bool is_factored = false;  ///< afterwards it gives no residual and no factors
  };
  void evaluate(const S&, const Y& y, Evaluation& at) const { at = {r(y), v(y)}; }
  int multipliers() const { return 1; }
  void accelerations(const S&, const Y& y, Y& v_dot, Y& lambda) const {
    lambda.setConstant(1, (m * v(y).squaredNorm() + r(y).dot(weight())) / r(y).squaredNorm());
    v_dot = (weight() - r(y) * lambda[0]) / m;
  }
  bool inertia_is_constant() const { return true; }
  void inertia_force(const Evaluation&, const Y& x, Y& force) const { force = m * x; }
  void applied_force(const Evaluation&, Y& force) const { force = weight(); }
  S residual(const Evaluation& at, const Y& force, const Y& lambda, Y& left) const {
    require_whole(at);
    left = weight() - force - at.r * lambda[0];
    return left.norm() / (weight().norm() + force.norm() + (at.r * lambda[0]).norm());
  }
  Violation<S> position_rows(const Evaluation& at, Y& phi) const {
    phi.setConstant(1, phi_of(at.r));
    return of_positions(phi[0]);
  }
  void clear_dependent(Y& /*lambda*/) const {}
  Violation<S> velocity_rows(const Evaluation& at, Y& phi_dot) const {
    phi_dot.setConstant(1, at.r.dot(at.v));
    return of_velocities(phi_dot[0], at.v);
  }
  S work_rate(const Evaluation&, const Y&) const { return S(0); }

  // Newton's matrix [m 1, r; r^T, 0]: gravity is constant and adds no stiffness
  using Factors = Evaluation;
  void factor(const Evaluation& at, const Shares<S>&, Factors& factors) const {
    require_whole(at);
    factors = at;
    at.is_factored = true;
  }
  void solve(const Factors& factors, const Evaluation&, const Y& left, const Y& rows, Y& x, Y& mu) const {
    const S multiplier = (factors.r.dot(left) - m * rows[0]) / factors.r.squaredNorm();
    mu[0] += multiplier;
    x += (left - factors.r * multiplier) / m;
  }
  void reduce(const Factors&, const Y& force, Y& left) const { left = force; }

  // the model has no internal rows and no springs
  bool normalise_step(const S&, Y&, Y&) const { return false; }
  void normalise_step_velocity(const S&, const Y&, Y&) const {}
  void internal_residual(const Evaluation&, const Y&, Y&) const {}
  void solve_internal_rows(const Evaluation&, const Y&, Y&) const {}
  int springs() const { return 0; }
  void spring_constants(Y& stiffness, Y& damping) const { stiffness = damping = Y(); }
  void solve(const Factors& factors, const Evaluation& at, const Y& left, const Y& rows, const Y&, Y& x,
             Y& mu, Y&) const {
    solve(factors, at, left, rows, x, mu);
  }

 private:
  static void require_whole(const Evaluation& at) {
    if (at.is_factored)
      throw std::logic_error("forces are requested from an evaluation that has been factored");
  }
  static Vector r(const Y& y) { return y.head(3); }
  static Vector v(const Y& y) { return y.tail(3); }
  static Y joined(const Vector& a, const Vector& b) {
    Y y(6);
    y << a, b;
    return y;
  }
  Vector weight() const { return {S(0), S(0), -m * g}; }
  S phi_of(const Vector& place) const { return (place.squaredNorm() - l * l) / 2; }
  S phi(const Y& y) const { return phi_of(r(y)); }
  S phi_dot(const Y& y) const { return r(y).dot(v(y)); }
  // Violations are relative to the pendulum's own numbers: for positions to l^2, for velocities to l times a
  // speed. This speed contains sqrt(g l), a speed of free fall, so that it is not 0 at rest.
  Violation<S> of_positions(const S& left) const {
    using std::abs;
    return {abs(left), abs(left) / (l * l), 0};
  }
  Violation<S> of_velocities(const S& left, const Vector& velocity) const {
    using std::abs, std::sqrt;
    return {abs(left), abs(left) / (l * (velocity.norm() + sqrt(g * l))), 0};
  }
  /// Change of r or v that changes the row by 1 and is smallest in the metric of M.
  const Vector& direction(const Y& y, bool factor) {
    if (factor) direction_ = r(y) / r(y).squaredNorm();
    return direction_;
  }

  Vector direction_;
};

static_assert(ConstrainedSystem<SphericalPendulum<double>>);

}  // namespace trivium::integrators
