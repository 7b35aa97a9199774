#pragma once
/// r-omega: the unknowns of a body are r'' and its angular acceleration omega_bar' in the body frame; the
/// rotation matrix A is the coordinate of orientation. Newton-Euler equations; Haug (1989), section 11.2:
///
///     m r'' + Phi_r^T lambda = F
///     J_bar omega_bar' + Phi_pi_bar^T lambda = n_bar - omega_bar x J_bar omega_bar

#include "bodies/rigid_body.hpp"
#include "bodies/rotations/so3.hpp"
#include "constraints/body_kinematics.hpp"
#include "formulations/formulation.hpp"

namespace trivium {

/// The formulation r-omega; formulation.hpp lists the contract of its members.
template <class S>
struct ROmega {
  using Scalar = S;
  using Unknown = Vector3<S>;

  // constants
  static constexpr std::string_view name = "r-omega";
  static constexpr int rotational_unknowns = 3;
  static constexpr int internal_constraints = 0;
  static constexpr int orientation_size = 4;
  using Orientation = Vector4<S>;

  using Chart = NoChart;

  /// Rotation A [3x3, body to global] and angular velocity omega_bar [rad/s, body frame].
  struct Coordinates {
    Matrix3<S> A = Matrix3<S>::Identity();
    Vector3<S> omega_bar = Vector3<S>::Zero();
  };

  // orientation: A itself is the coordinate
  /// Motion of a body and of the vectors fixed in it; a model of the concept BodyKinematics.
  struct Kinematics : BodyMotion<S> {
    using Scalar = S;
    static constexpr int rotational_unknowns = 3;

    Vector3<S> omega;  ///< angular velocity A omega_bar [rad/s, global]

    /// a = A a_bar, its rate A tilde(omega_bar) a_bar = omega x a, and its bias A tilde(omega_bar)^2 a_bar:
    /// a'' at omega_bar' = 0.
    BodyVector<S> vector(const Vector3<S>& a_bar) const {
      const Vector3<S> a = this->A * a_bar, rate = omega.cross(a);
      return {a_bar, a, rate, omega.cross(rate)};
    }
    /// B = -A tilde(a_bar) [3x3]: (A a_bar)' = B omega_bar.
    Matrix3<S> jacobian(const BodyVector<S>& v) const { return -times_tilde<S>(this->A, v.a_bar); }
    /// w^T B [1x3].
    Matrix<S, 1, 3> jacobian_along(const BodyVector<S>& v, const Vector3<S>& w) const {
      return v.a_bar.cross(Vector3<S>(this->A.transpose() * w)).transpose();
    }
  };
  static Kinematics kinematics(const Chart&, const Vector3<S>& r, const Vector3<S>& r_dot,
                               const Coordinates& q) {
    return {BodyMotion<S>{r, r_dot, q.A, q.omega_bar}, q.A * q.omega_bar};
  }

  // mass block: J_bar
  static Matrix3<S> mass_block(const Kinematics&, const Matrix3<S>& J_bar) { return J_bar; }

  // quadratic-velocity force: -tilde(omega_bar) J_bar omega_bar
  static Unknown velocity_force(const Kinematics& k, const Matrix3<S>& J_bar) {
    return -k.omega_bar.cross(J_bar * k.omega_bar);
  }
  static Unknown applied_force(const Kinematics&, const Vector3<S>& n_bar) { return n_bar; }

  // internal constraint row: none
  static Matrix<S, 0, 3> internal_jacobian(const Kinematics&) { return {}; }
  static Vector<S, 0> internal_gamma(const Kinematics&) { return {}; }

  // reduced equations (internal row eliminated): there is no internal row, so x = omega_bar'
  using Reduced = Kinematics;
  static constexpr bool reduced_mass_is_constant = true;
  static AngularMotion<S> angular_motion(const Reduced& k) { return {k.A, k.A, k.omega, Vector3<S>::Zero()}; }
  static Matrix3<S> reduced_mass_block(const Kinematics&, const Matrix3<S>& J_bar) { return J_bar; }
  static Vector3<S> reduced_force(const Kinematics& k, const Matrix3<S>& J_bar, const Vector3<S>& n_bar) {
    return applied_force(k, n_bar) + velocity_force(k, J_bar);
  }
  static Unknown from_reduced(const Kinematics&, const Vector3<S>& omega_bar_dot) { return omega_bar_dot; }
  static Unknown increment(const Kinematics&, const Vector3<S>& x) { return x; }
  static Vector3<S> omega_bar_dot_from_reduced(const Kinematics&, const Vector3<S>& x) { return x; }

  // unknown and angular acceleration: the unknown is omega_bar'
  static Matrix3<S> lift(const Kinematics&) { return Matrix3<S>::Identity(); }
  static Vector3<S> to_angular_acceleration(const Kinematics&, const Unknown& omega_bar_dot) {
    return omega_bar_dot;
  }

  // orientation in an integrator: p, with the rate p' = 1/2 G^T omega_bar; A depends on the direction of p
  // only. Retraction: A exp(tilde(phi))
  static Orientation orientation_of(const Chart&, const Vector4<S>& p) { return p; }
  static Unknown velocity_of(const Chart&, const Coordinates& q) { return q.omega_bar; }
  static Coordinates from_orientation(const Chart&, const Orientation& p, const Unknown& omega_bar) {
    return {rotation_matrix<S>(p / p.norm()), omega_bar};
  }
  static Orientation orientation_rate(const Chart&, const Orientation& p, const Unknown& omega_bar) {
    return G_matrix(p).transpose() * omega_bar / 2;
  }
  static Orientation retract(const Chart&, const Orientation& p, const Unknown& phi) {
    const Orientation moved = multiply_parameters<S>(p, exponential_parameters(phi));
    return moved / moved.norm();
  }
  static void normalise(Orientation& p, Unknown&) { p /= p.norm(); }

  // steps of implicit methods: a displacement is a rotation vector phi [rad, body frame], A becomes A
  // exp(tilde(phi))
  static Orientation step(const Chart& chart, const Orientation& p, const Unknown& phi) {
    return retract(chart, p, phi);
  }
  static Unknown displacement(const Chart&, const Orientation& from, const Orientation& to) {
    return rotation_vector(multiply_parameters<S>(conjugate_parameters(from), to));
  }
  static Unknown displacement_rate(const Unknown& phi, const Unknown& omega_bar) {
    return rotation_vector_rate(phi, omega_bar);
  }
  static void normalise_step(Orientation&, const S&, Unknown&) {}
  static void normalise_step_velocity(const Orientation&, const Unknown&, const S&, Unknown&) {}
  static constexpr bool inertia_is_constant = true;
  // generalized forces in the reduced unknowns, and as a moment [N m, body frame]: the same numbers here
  static Vector3<S> reduced(const Reduced&, const Unknown& force) { return force; }
  static Vector3<S> moment(const Reduced&, const Vector3<S>& n_bar) { return n_bar; }

  // conversion from and to a pose
  static S chart_distance(const Chart&, const Coordinates&) { return S(1); }
  static Chart choose_chart(const ChartOptions&, const Vector4<S>&) { return {}; }
  static Coordinates from_pose(const Chart&, const Vector4<S>& p, const Vector3<S>& omega_bar) {
    return {rotation_matrix(p), omega_bar};
  }
  static Vector4<S> to_euler_parameters(const Chart&, const Coordinates& q) { return euler_parameters(q.A); }
};

static_assert(Formulation<ROmega<double>>);

}  // namespace trivium
