#pragma once
/// r-omega: r'' and the body-frame angular acceleration omega_bar'. Newton-Euler equations; Haug (1989),
/// section 11.2.

#include "formulations/formulation.hpp"

namespace trivium {

template <class S>
struct ROmega {
  using Scalar = S;
  using Unknown = Vector3<S>;

  // constants
  static constexpr std::string_view name = "r-omega";
  static constexpr int rotational_unknowns = 3;
  static constexpr int internal_constraints = 0;
  static constexpr BlockNames block_names{
      "omega_bar'", "J_bar", "Phi_pi_bar", "n_bar - omega~ J_bar omega_bar", "", ""};

  using Chart = NoChart;

  /// A itself, and omega_bar.
  struct Coordinates {
    Matrix3<S> A = Matrix3<S>::Identity();
    Vector3<S> omega_bar = Vector3<S>::Zero();
  };

  // orientation: A is a coordinate
  struct Kinematics : BodyMotion<S> {
    using Scalar = S;
    static constexpr int rotational_unknowns = 3;

    /// B = -A tilde(abar): (A abar)' = B omega_bar.
    Matrix3<S> vector_jacobian(const Vector3<S>& a_bar) const { return -this->A * tilde(a_bar); }
    /// A tilde(omega_bar) abar.
    Vector3<S> vector_rate(const Vector3<S>& a_bar) const { return this->A * this->omega_bar.cross(a_bar); }
    /// A tilde(omega_bar)^2 abar.
    Vector3<S> vector_bias(const Vector3<S>& a_bar) const {
      return this->A * this->omega_bar.cross(this->omega_bar.cross(a_bar));
    }
  };
  static Kinematics kinematics(const Chart&, const Vector3<S>& r, const Vector3<S>& r_dot,
                               const Coordinates& q) {
    return {BodyMotion<S>{r, r_dot, q.A, q.omega_bar}};
  }

  // mass block
  static Matrix3<S> mass_block(const Kinematics&, const Matrix3<S>& J_bar) { return J_bar; }

  // quadratic-velocity force: -tilde(omega_bar) Jbar omega_bar
  static Unknown velocity_force(const Kinematics& k, const Matrix3<S>& J_bar) {
    return -k.omega_bar.cross(J_bar * k.omega_bar);
  }
  static Unknown applied_force(const Kinematics&, const Vector3<S>& n_bar) { return n_bar; }

  // internal row: none
  static Matrix<S, 0, 3> internal_jacobian(const Kinematics&) { return {}; }
  static Vector<S, 0> internal_gamma(const Kinematics&) { return {}; }

  // the unknown is omega_bar'
  static Matrix3<S> lift(const Kinematics&) { return Matrix3<S>::Identity(); }
  static Vector3<S> to_angular_acceleration(const Kinematics&, const Unknown& omega_bar_dot) {
    return omega_bar_dot;
  }
  static Unknown from_angular_acceleration(const Kinematics&, const Vector3<S>& omega_bar_dot) {
    return omega_bar_dot;
  }

  // retraction: A exp(tilde(phi))
  static Coordinates retract(const Chart&, const Coordinates& q, const Unknown& phi) {
    return {q.A * rotation_matrix(exponential_parameters(phi)), q.omega_bar};
  }

  // conversion from and to a pose
  static Chart choose_chart(const ChartOptions&, const Vector4<S>&) { return {}; }
  static Coordinates from_pose(const Chart&, const Vector4<S>& p, const Vector3<S>& omega_bar) {
    return {rotation_matrix(p), omega_bar};
  }
  static Vector4<S> to_euler_parameters(const Chart&, const Coordinates& q) { return euler_parameters(q.A); }
};

static_assert(Formulation<ROmega<double>>);

}  // namespace trivium
