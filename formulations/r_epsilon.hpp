#pragma once
/// r-epsilon: the unknowns of a body are r'' and the second derivatives epsilon'' of three Euler angles, in
/// any of the twelve body-fixed sequences. Each body has its own chart A = A(epsilon) C
/// (euler_chart_choice.hpp). Haug (1989), section 9.3 and problem 11.2, with omega_bar = D epsilon':
///
///     m r'' + Phi_r^T lambda = F
///     D^T J_bar D epsilon'' + Phi_epsilon^T lambda
///         = D^T (n_bar - omega_bar x J_bar omega_bar - J_bar D' epsilon')
///
/// These equations are solved for epsilon'' as printed. At an angle theta from the singularity of the
/// sequence the relative error of lambda grows as u / theta^3; in r_epsilon_omega_first it grows as
/// u / theta.

#include "bodies/rigid_body.hpp"
#include "bodies/rotations/euler_angles.hpp"
#include "constraints/body_kinematics.hpp"
#include "formulations/euler_chart_choice.hpp"

namespace trivium {

/// The formulation r-epsilon; formulation.hpp lists the contract of its members.
template <class S>
struct REpsilon {
  using Scalar = S;
  using Unknown = Vector3<S>;

  // constants
  static constexpr std::string_view name = "r-epsilon";
  static constexpr int rotational_unknowns = 3;
  static constexpr int internal_constraints = 0;
  static constexpr int orientation_size = 3;
  using Orientation = Vector3<S>;

  using Chart = EulerChart<S>;

  /// Euler angles epsilon [rad] and their rates epsilon' [rad/s].
  struct Coordinates {
    Vector3<S> epsilon = Vector3<S>::Zero(), epsilon_dot = Vector3<S>::Zero();
  };

  // orientation: A = R_1 R_2 R_3 C; R_k is the rotation by epsilon_k about axis e_k of the sequence
  /// Motion of a body and of the vectors fixed in it; a model of the concept BodyKinematics.
  struct Kinematics : BodyMotion<S> {
    using Scalar = S;
    static constexpr int rotational_unknowns = 3;
    Matrix3<S> g;  ///< axes of the elementary rotations in the global frame: [e_1, R_1 e_2, R_1 R_2 e_3]
    Vector3<S> omega, g_dot_rates;  ///< g epsilon' [rad/s] and g' epsilon' [rad/s^2], both global
    Matrix3<S> D;            ///< A^T g [3x3, -]: omega_bar = D epsilon'; singular where the sequence is
    Vector3<S> D_dot_rates;  ///< D' epsilon' = A^T g' epsilon' [rad/s^2, body frame]

    /// a = A a_bar, its rate B(epsilon, a_bar) epsilon' = omega x a, and its bias B' epsilon': a'' at
    /// epsilon'' = 0.
    BodyVector<S> vector(const Vector3<S>& a_bar) const {
      const Vector3<S> a = this->A * a_bar, rate = omega.cross(a);
      return {a_bar, a, rate, g_dot_rates.cross(a) + omega.cross(rate)};
    }
    /// B = [A_phi a_bar, A_theta a_bar, A_psi a_bar] = [g_1 x a, g_2 x a, g_3 x a] [3x3].
    Matrix3<S> jacobian(const BodyVector<S>& v) const {
      Matrix3<S> B;
      for (int k = 0; k < 3; ++k) B.col(k) = g.col(k).cross(v.a);
      return B;
    }
    /// w^T B [1x3].
    Matrix<S, 1, 3> jacobian_along(const BodyVector<S>& v, const Vector3<S>& w) const {
      return v.a.cross(w).transpose() * g;
    }
  };
  static Kinematics kinematics(const Chart& chart, const Vector3<S>& r, const Vector3<S>& r_dot,
                               const Coordinates& q) {
    return with_axes(chart.sequence, [&]<int i, int j, int k>(Axes<i, j, k>) {
      return kinematics_about<i, j, k>(chart, r, r_dot, q);
    });
  }

  // mass block: J^epsilon = D^T J_bar D
  static Matrix3<S> mass_block(const Kinematics& k, const Matrix3<S>& J_bar) {
    return k.D.transpose() * J_bar * k.D;
  }

  // quadratic-velocity force: -D^T (tilde(omega_bar) J_bar omega_bar + J_bar D' epsilon')
  static Unknown velocity_force(const Kinematics& k, const Matrix3<S>& J_bar) {
    return -k.D.transpose() * (k.omega_bar.cross(J_bar * k.omega_bar) + J_bar * k.D_dot_rates);
  }
  static Unknown applied_force(const Kinematics& k, const Vector3<S>& n_bar) {
    return k.D.transpose() * n_bar;
  }

  // internal constraint row: none
  static Matrix<S, 0, 3> internal_jacobian(const Kinematics&) { return {}; }
  static Vector<S, 0> internal_gamma(const Kinematics&) { return {}; }

  // reduced equations (internal row eliminated): there is no internal row, so x = epsilon''
  using Reduced = Kinematics;
  static constexpr bool reduced_mass_is_constant = false;
  static AngularMotion<S> angular_motion(const Reduced& k) { return {k.A, k.g, k.omega, k.g_dot_rates}; }
  static Matrix3<S> reduced_mass_block(const Kinematics& k, const Matrix3<S>& J_bar) {
    return mass_block(k, J_bar);
  }
  static Vector3<S> reduced_force(const Kinematics& k, const Matrix3<S>& J_bar, const Vector3<S>& n_bar) {
    return k.D.transpose() * (n_bar - k.omega_bar.cross(J_bar * k.omega_bar) - J_bar * k.D_dot_rates);
  }
  static Unknown from_reduced(const Kinematics&, const Vector3<S>& epsilon_ddot) { return epsilon_ddot; }
  static Unknown increment(const Kinematics&, const Vector3<S>& x) { return x; }
  static Vector3<S> omega_bar_dot_from_reduced(const Kinematics& k, const Vector3<S>& x) {
    return to_angular_acceleration(k, x);
  }

  // unknown and angular acceleration: omega_bar' = D epsilon'' + D' epsilon'
  static Matrix3<S> lift(const Kinematics& k) { return k.D.inverse(); }
  static Vector3<S> to_angular_acceleration(const Kinematics& k, const Unknown& epsilon_ddot) {
    return k.D * epsilon_ddot + k.D_dot_rates;
  }

  // orientation in an integrator: epsilon, with the rate epsilon'. Retraction: epsilon + increment
  static Orientation orientation_of(const Chart& chart, const Vector4<S>& p) {
    return euler_angles<S>(chart.sequence, rotation_matrix(p) * chart.C.transpose());
  }
  static Unknown velocity_of(const Chart&, const Coordinates& q) { return q.epsilon_dot; }
  static Coordinates from_orientation(const Chart&, const Orientation& epsilon, const Unknown& epsilon_dot) {
    return {epsilon, epsilon_dot};
  }
  static Orientation orientation_rate(const Chart&, const Orientation&, const Unknown& epsilon_dot) {
    return epsilon_dot;
  }
  static Orientation retract(const Chart&, const Orientation& epsilon, const Unknown& increment) {
    return epsilon + increment;
  }
  static void normalise(Orientation&, Unknown&) {}

  // steps of implicit methods: angles and rates are added as plain vectors
  static Orientation step(const Chart&, const Orientation& epsilon, const Unknown& change) {
    return epsilon + change;
  }
  static Unknown displacement(const Chart&, const Orientation& from, const Orientation& to) {
    return to - from;
  }
  static Unknown displacement_rate(const Unknown&, const Unknown& epsilon_dot) { return epsilon_dot; }
  static void normalise_step(Orientation&, const S&, Unknown&) {}
  static void normalise_step_velocity(const Orientation&, const Unknown&, const S&, Unknown&) {}
  static constexpr bool inertia_is_constant = false;
  // generalized forces in the reduced unknowns, and as a moment [N m, body frame]: force = D^T moment
  static Vector3<S> reduced(const Reduced&, const Unknown& force) { return force; }
  static Vector3<S> moment(const Reduced& k, const Vector3<S>& force) {
    return k.D.transpose().inverse() * force;
  }

  // conversion from and to a pose: epsilon' = D^-1 omega_bar
  static S chart_distance(const Chart& chart, const Coordinates& q) {
    using std::abs, std::cos, std::sin;
    return abs(chart.sequence.is_symmetric() ? sin(q.epsilon[1]) : cos(q.epsilon[1]));
  }
  static Chart choose_chart(const ChartOptions& options, const Vector4<S>& p) {
    return choose_euler_chart<S>(options, p);
  }
  static Coordinates from_pose(const Chart& chart, const Vector4<S>& p, const Vector3<S>& omega_bar) {
    Coordinates q;
    q.epsilon = euler_angles<S>(chart.sequence, rotation_matrix(p) * chart.C.transpose());
    const Vector3<S> none = Vector3<S>::Zero();
    q.epsilon_dot = kinematics(chart, none, none, q).D.inverse() * omega_bar;
    return q;
  }
  static Vector4<S> to_euler_parameters(const Chart& chart, const Coordinates& q) {
    return euler_parameters<S>(euler_rotation(chart.sequence, q.epsilon) * chart.C);
  }

 private:
  template <int first_axis, int second_axis, int third_axis>
  static Kinematics kinematics_about(const Chart& chart, const Vector3<S>& r, const Vector3<S>& r_dot,
                                     const Coordinates& q) {
    const Vector3<S>& rate = q.epsilon_dot;
    PaddedColumns<S, 3> R = PaddedColumns<S, 3>::Identity(), g;
    g.col(0) = R.col(first_axis);
    turn<S>(R, first_axis, q.epsilon[0]);
    g.col(1) = R.col(second_axis);
    turn<S>(R, second_axis, q.epsilon[1]);
    g.col(2) = R.col(third_axis);
    turn<S>(R, third_axis, q.epsilon[2]);
    const PaddedColumns<S, 3> A = times<S, 3>(R, chart.C), A_T = transposed<S>(A);
    // an axis moves with the rotations before it: g_k' = (sum over m < k of epsilon_m' g_m) x g_k
    const Padded<S> first = rate[0] * g.col(0), second = first + rate[1] * g.col(1);
    const Padded<S> g_dot_rates =
        rate[1] * cross_product<S>(first, g.col(1)) + rate[2] * cross_product<S>(second, g.col(2));
    Kinematics k;
    k.r = r;
    k.r_dot = r_dot;
    k.A = A.template topRows<3>();
    k.g = g.template topRows<3>();
    k.omega = unpadded<S>(second + rate[2] * g.col(2));
    k.g_dot_rates = unpadded<S>(g_dot_rates);
    k.D = times<S, 3>(A_T, g).template topRows<3>();
    k.D_dot_rates = unpadded<S>(times<S, 3>(A_T, g_dot_rates));
    k.omega_bar = k.D * rate;
    return k;
  }
};

static_assert(Formulation<REpsilon<double>>);

}  // namespace trivium
