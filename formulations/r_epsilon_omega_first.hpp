#pragma once
/// r-epsilon-omega-first: the coordinates of a body are r and Euler angles epsilon, its unknowns are r''
/// and omega_bar'. The equations of r-omega are solved for omega_bar' and lambda; then epsilon'' follows
/// from omega_bar = D epsilon':
///
///     epsilon'' = D^-1 (omega_bar' - D' epsilon')
///
/// At an angle theta from the singularity of the sequence the relative error of lambda grows as u / theta;
/// in the printed form (r_epsilon) it grows as u / theta^3.

#include "bodies/rigid_body.hpp"
#include "bodies/rotations/euler_angles.hpp"
#include "formulations/r_epsilon.hpp"
#include "formulations/r_omega.hpp"

namespace trivium {

/// The formulation r-epsilon-omega-first; formulation.hpp lists the contract of its members.
template <class S>
struct REpsilonOmegaFirst {
  using Scalar = S;
  using Unknown = Vector3<S>;
  using Angles = REpsilon<S>;
  using Rates = ROmega<S>;

  // constants
  static constexpr std::string_view name = "r-epsilon-omega-first";
  static constexpr int rotational_unknowns = 3;
  static constexpr int internal_constraints = 0;
  static constexpr int orientation_size = 3;
  using Orientation = Vector3<S>;

  using Chart = typename Angles::Chart;
  using Coordinates = typename Angles::Coordinates;

  // orientation: A = A(epsilon) C; a body vector has the rate and the Jacobian of r-omega, with omega_bar =
  // D epsilon'
  /// The kinematics of r-omega, with D to convert omega_bar' to epsilon''.
  struct Kinematics : Rates::Kinematics {
    Matrix3<S> D;            ///< omega_bar = D epsilon' [3x3, -]
    Vector3<S> D_dot_rates;  ///< D' epsilon' [rad/s^2, body frame]

    /// epsilon'' [rad/s^2] of an angular acceleration omega_bar' [rad/s^2, body frame].
    Vector3<S> epsilon_ddot(const Vector3<S>& omega_bar_dot) const {
      return D.inverse() * (omega_bar_dot - D_dot_rates);
    }
  };
  static Kinematics kinematics(const Chart& chart, const Vector3<S>& r, const Vector3<S>& r_dot,
                               const Coordinates& q) {
    const typename Angles::Kinematics k = Angles::kinematics(chart, r, r_dot, q);
    return {{BodyMotion<S>(k), k.A * k.omega_bar}, k.D, k.D_dot_rates};
  }

  // mass block and quadratic-velocity force: those of r-omega
  static Matrix3<S> mass_block(const Kinematics& k, const Matrix3<S>& J_bar) {
    return Rates::mass_block(k, J_bar);
  }
  static Unknown velocity_force(const Kinematics& k, const Matrix3<S>& J_bar) {
    return Rates::velocity_force(k, J_bar);
  }
  static Unknown applied_force(const Kinematics& k, const Vector3<S>& n_bar) {
    return Rates::applied_force(k, n_bar);
  }

  // internal constraint row: none
  static Matrix<S, 0, 3> internal_jacobian(const Kinematics&) { return {}; }
  static Vector<S, 0> internal_gamma(const Kinematics&) { return {}; }

  // reduced equations (internal row eliminated): there is no internal row, so x = omega_bar'
  using Reduced = Kinematics;
  static constexpr bool reduced_mass_is_constant = true;
  static AngularMotion<S> angular_motion(const Reduced& k) { return Rates::angular_motion(k); }
  static Matrix3<S> reduced_mass_block(const Kinematics&, const Matrix3<S>& J_bar) { return J_bar; }
  static Vector3<S> reduced_force(const Kinematics& k, const Matrix3<S>& J_bar, const Vector3<S>& n_bar) {
    return Rates::reduced_force(k, J_bar, n_bar);
  }
  static Unknown from_reduced(const Kinematics&, const Vector3<S>& omega_bar_dot) { return omega_bar_dot; }
  static Unknown increment(const Kinematics&, const Vector3<S>& x) { return x; }
  static Vector3<S> omega_bar_dot_from_reduced(const Kinematics&, const Vector3<S>& x) { return x; }

  // unknown and angular acceleration: the unknown is omega_bar'
  static Matrix3<S> lift(const Kinematics& k) { return Rates::lift(k); }
  static Vector3<S> to_angular_acceleration(const Kinematics&, const Unknown& omega_bar_dot) {
    return omega_bar_dot;
  }

  // orientation in an integrator: epsilon, with the rate epsilon' = D^-1 omega_bar. Retraction: epsilon +
  // D^-1 phi, which turns the body by phi to first order
  static Orientation orientation_of(const Chart& chart, const Vector4<S>& p) {
    return Angles::orientation_of(chart, p);
  }
  static Unknown velocity_of(const Chart& chart, const Coordinates& q) {
    return angles_at(chart, q).D * q.epsilon_dot;
  }
  static Coordinates from_orientation(const Chart& chart, const Orientation& epsilon,
                                      const Unknown& omega_bar) {
    return {epsilon, orientation_rate(chart, epsilon, omega_bar)};
  }
  static Orientation orientation_rate(const Chart& chart, const Orientation& epsilon,
                                      const Unknown& omega_bar) {
    return angles_at(chart, {epsilon, Orientation::Zero()}).D.inverse() * omega_bar;
  }
  static Orientation retract(const Chart& chart, const Orientation& epsilon, const Unknown& phi) {
    return epsilon + orientation_rate(chart, epsilon, phi);
  }
  static void normalise(Orientation&, Unknown&) {}

  // steps of implicit methods: a displacement is a rotation vector phi [rad, body frame], A becomes A
  // exp(tilde(phi))
  static Orientation step(const Chart& chart, const Orientation& epsilon, const Unknown& phi) {
    return euler_angles_near<S>(
        epsilon, chart.sequence,
        rotation_at(chart, epsilon) * rotation_matrix(exponential_parameters(phi)) * chart.C.transpose());
  }
  static Unknown displacement(const Chart& chart, const Orientation& from, const Orientation& to) {
    return rotation_vector(
        euler_parameters<S>(rotation_at(chart, from).transpose() * rotation_at(chart, to)));
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
  static S chart_distance(const Chart& chart, const Coordinates& q) {
    return Angles::chart_distance(chart, q);
  }
  static Chart choose_chart(const ChartOptions& options, const Vector4<S>& p) {
    return Angles::choose_chart(options, p);
  }
  static Coordinates from_pose(const Chart& chart, const Vector4<S>& p, const Vector3<S>& omega_bar) {
    return Angles::from_pose(chart, p, omega_bar);
  }
  static Vector4<S> to_euler_parameters(const Chart& chart, const Coordinates& q) {
    return Angles::to_euler_parameters(chart, q);
  }

 private:
  static Matrix3<S> rotation_at(const Chart& chart, const Orientation& epsilon) {
    return euler_rotation(chart.sequence, epsilon) * chart.C;
  }
  static typename Angles::Kinematics angles_at(const Chart& chart, const Coordinates& q) {
    const Vector3<S> none = Vector3<S>::Zero();
    return Angles::kinematics(chart, none, none, q);
  }
};

static_assert(Formulation<REpsilonOmegaFirst<double>>);

}  // namespace trivium
