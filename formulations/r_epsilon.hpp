#pragma once
/// r-epsilon: r'' and the second derivative epsilon'' of three Euler angles, in any of the twelve body-fixed
/// sequences, each body in its own chart A = A(epsilon) C (euler_chart.hpp). Haug (1989), section 9.3 and
/// problem 11.2: the equations as printed, solved for epsilon''. Near its singularity (distance theta) this
/// form loses lambda as u / theta^3; r_epsilon_omega_first loses u / theta.

#include "formulations/euler_chart.hpp"

namespace trivium {

template <class S>
struct REpsilon {
  using Scalar = S;
  using Unknown = Vector3<S>;

  // constants
  static constexpr std::string_view name = "r-epsilon";
  static constexpr int rotational_unknowns = 3;
  static constexpr int internal_constraints = 0;
  static constexpr BlockNames block_names{"epsilon''", "J^epsilon", "Phi_epsilon", "tau", "", ""};

  using Chart = EulerChart<S>;

  struct Coordinates {
    Vector3<S> epsilon = Vector3<S>::Zero(), epsilon_dot = Vector3<S>::Zero();
  };

  // orientation: A = R_1 R_2 R_3 C
  struct Kinematics : BodyMotion<S> {
    using Scalar = S;
    static constexpr int rotational_unknowns = 3;
    Matrix3<S> R_1, R_2, R_3, C;
    Vector3<S> e_1, e_2, e_3;  ///< the axes of the three turns
    Vector3<S> epsilon_dot;
    Matrix3<S> D;            ///< D(epsilon): omega_bar = D epsilon'; singular where the sequence is
    Vector3<S> D_dot_rates;  ///< D' epsilon'

    /// [A_phi abar, A_theta abar, A_psi abar].
    Matrix3<S> vector_jacobian(const Vector3<S>& a_bar) const {
      const Vector3<S> x_3 = R_3 * (C * a_bar), x_2 = R_2 * x_3, x_1 = R_1 * x_2;
      Matrix3<S> B;
      B << e_1.cross(x_1), R_1 * e_2.cross(x_2), R_1 * (R_2 * e_3.cross(x_3));
      return B;
    }
    Vector3<S> vector_rate(const Vector3<S>& a_bar) const { return vector_jacobian(a_bar) * epsilon_dot; }
    /// B'(epsilon, epsilon', abar) epsilon': each turn adds 2 a' e x w' + a'^2 e x (e x w) to the vector w it
    /// carries.
    Vector3<S> vector_bias(const Vector3<S>& a_bar) const {
      Vector3<S> w = C * a_bar, w_dot = Vector3<S>::Zero(), bias = Vector3<S>::Zero();
      const auto turn = [&](const Matrix3<S>& R, const Vector3<S>& e, const S& rate) {
        bias = R * (bias + 2 * rate * e.cross(w_dot) + rate * rate * e.cross(e.cross(w)));
        w_dot = R * (w_dot + rate * e.cross(w));
        w = R * w;
      };
      turn(R_3, e_3, epsilon_dot[2]);
      turn(R_2, e_2, epsilon_dot[1]);
      turn(R_1, e_1, epsilon_dot[0]);
      return bias;
    }
  };
  static Kinematics kinematics(const Chart& chart, const Vector3<S>& r, const Vector3<S>& r_dot,
                               const Coordinates& q) {
    Kinematics k;
    const auto& axis = chart.sequence.axis;
    k.R_1 = axis_rotation(axis[0], q.epsilon[0]);
    k.R_2 = axis_rotation(axis[1], q.epsilon[1]);
    k.R_3 = axis_rotation(axis[2], q.epsilon[2]);
    k.C = chart.C;
    k.e_1 = unit_axis<S>(axis[0]);
    k.e_2 = unit_axis<S>(axis[1]);
    k.e_3 = unit_axis<S>(axis[2]);
    k.epsilon_dot = q.epsilon_dot;
    // columns of C D: the three axes seen from the body side of the later turns, and their rates
    const Vector3<S> y = k.R_2.transpose() * k.e_1, y_dot = -q.epsilon_dot[1] * k.e_2.cross(y);
    const Vector3<S> d_1 = k.R_3.transpose() * y, d_2 = k.R_3.transpose() * k.e_2;
    const Vector3<S> d_1_dot = k.R_3.transpose() * y_dot - q.epsilon_dot[2] * k.e_3.cross(d_1);
    const Vector3<S> d_2_dot = -q.epsilon_dot[2] * k.e_3.cross(d_2);
    Matrix3<S> CD;
    CD << d_1, d_2, k.e_3;
    k.D = chart.C.transpose() * CD;
    k.D_dot_rates = chart.C.transpose() * (d_1_dot * q.epsilon_dot[0] + d_2_dot * q.epsilon_dot[1]);
    k.r = r;
    k.r_dot = r_dot;
    k.A = k.R_1 * (k.R_2 * (k.R_3 * k.C));
    k.omega_bar = k.D * q.epsilon_dot;
    return k;
  }

  // mass block: J^epsilon = D^T Jbar D
  static Matrix3<S> mass_block(const Kinematics& k, const Matrix3<S>& J_bar) {
    return k.D.transpose() * J_bar * k.D;
  }

  // quadratic-velocity force: -D^T (tilde(omega_bar) Jbar omega_bar + Jbar D' epsilon')
  static Unknown velocity_force(const Kinematics& k, const Matrix3<S>& J_bar) {
    return -k.D.transpose() * (k.omega_bar.cross(J_bar * k.omega_bar) + J_bar * k.D_dot_rates);
  }
  static Unknown applied_force(const Kinematics& k, const Vector3<S>& n_bar) {
    return k.D.transpose() * n_bar;
  }

  // internal row: none
  static Matrix<S, 0, 3> internal_jacobian(const Kinematics&) { return {}; }
  static Vector<S, 0> internal_gamma(const Kinematics&) { return {}; }

  // the unknown and omega_bar': omega_bar' = D epsilon'' + D' epsilon'
  static Matrix3<S> lift(const Kinematics& k) { return k.D.inverse(); }
  static Vector3<S> to_angular_acceleration(const Kinematics& k, const Unknown& epsilon_ddot) {
    return k.D * epsilon_ddot + k.D_dot_rates;
  }
  static Unknown from_angular_acceleration(const Kinematics& k, const Vector3<S>& omega_bar_dot) {
    return k.D.inverse() * (omega_bar_dot - k.D_dot_rates);
  }

  // retraction: angles add
  static Coordinates retract(const Chart&, const Coordinates& q, const Unknown& increment) {
    return {q.epsilon + increment, q.epsilon_dot};
  }

  // conversion from and to a pose: epsilon' = D^-1 omega_bar
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
};

static_assert(Formulation<REpsilon<double>>);

}  // namespace trivium
