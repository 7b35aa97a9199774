#pragma once
/// r-phi: a formulation whose rotational coordinates are a rotation vector phi, A = A_0 exp(tilde(phi)); the
/// unknowns are r'' and phi''. The chart of a body is A_0, the orientation from which phi counts. With T(phi)
/// of Bauchau and Trainelli (Nonlinear Dynamics 32, 2003), omega_bar = T phi' and omega_bar' = T phi'' + T'
/// phi'. T is singular after a full turn.
///
/// This class contains only the printed equations. ReducedToRotation derives from them the functions that the
/// structured solver and simulations need.

#include <bodies/rigid_body.hpp>
#include <bodies/rotations/so3.hpp>
#include <formulations/contract/equations_as_printed.hpp>

template <class S>
struct RotationVector {
  using Scalar = S;
  using Vector3 = trivium::Vector3<S>;
  using Vector4 = trivium::Vector4<S>;
  using Matrix3 = trivium::Matrix3<S>;
  using Unknown = Vector3;

  static constexpr std::string_view name = "r-phi";
  static constexpr int rotational_unknowns = 3;
  static constexpr int internal_constraints = 0;

  struct Chart {
    Vector4 p_0 = Vector4::Unit(0);
    std::string_view name() const { return "rotation vector"; }
  };
  struct Coordinates {
    Vector3 phi = Vector3::Zero(), phi_dot = Vector3::Zero();
  };

  /// The sum over k of (-s)^k / (first + 2 k)! with s = |phi|^2, and its derivative with respect to s. Up to
  /// a full turn, |phi| = 2 pi, 60 terms are enough for every Scalar: the next one is below 1e-105.
  struct Series {
    S value{0}, slope{0};
    Series(int first, const S& s) {
      S term(1);
      for (int n = 2; n <= first; ++n) term /= S(n);
      for (int k = 0; k < 60; ++k) {
        value += term;
        const S next = -term / S((first + 2 * k + 1) * (first + 2 * k + 2));
        slope += S(k + 1) * next;
        term = next * s;
      }
    }
  };
  // a = (1 - cos |phi|) / |phi|^2 and b = (|phi| - sin |phi|) / |phi|^3, as series without cancellation near
  // phi = 0
  static Series a(const Vector3& phi) { return {2, phi.squaredNorm()}; }
  static Series b(const Vector3& phi) { return {3, phi.squaredNorm()}; }

  static Matrix3 T(const Vector3& phi) {
    const Matrix3 tilde = trivium::tilde(phi);
    return Matrix3::Identity() - a(phi).value * tilde + b(phi).value * tilde * tilde;
  }
  /// T' phi' [3x1], the bias of omega_bar'.
  static Vector3 T_dot_rates(const Vector3& phi, const Vector3& phi_dot) {
    const Vector3 turn = phi.cross(phi_dot);
    const S s_dot = 2 * phi.dot(phi_dot);
    return -a(phi).slope * s_dot * turn + b(phi).slope * s_dot * phi.cross(turn) +
           b(phi).value * phi_dot.cross(turn);
  }

  struct Kinematics : trivium::BodyMotion<S> {
    using Scalar = S;
    static constexpr int rotational_unknowns = 3;
    Matrix3 T;
    Vector3 T_dot_rates, omega;

    trivium::BodyVector<S> vector(const Vector3& a_bar) const {
      const Vector3 a = this->A * a_bar, rate = omega.cross(a);
      return {a_bar, a, rate, (this->A * T_dot_rates).cross(a) + omega.cross(rate)};
    }
    Matrix3 jacobian(const trivium::BodyVector<S>& v) const { return -trivium::tilde(v.a) * this->A * T; }
    Eigen::Matrix<S, 1, 3> jacobian_along(const trivium::BodyVector<S>& v, const Vector3& w) const {
      return w.transpose() * jacobian(v);
    }
  };
  static Kinematics kinematics(const Chart& chart, const Vector3& r, const Vector3& r_dot,
                               const Coordinates& q) {
    const Matrix3 A = trivium::rotation_matrix(to_euler_parameters(chart, q)), at = T(q.phi);
    const Vector3 omega_bar = at * q.phi_dot;
    return {{r, r_dot, A, omega_bar}, at, T_dot_rates(q.phi, q.phi_dot), A * omega_bar};
  }

  static Matrix3 mass_block(const Kinematics& k, const Matrix3& J_bar) {
    return k.T.transpose() * J_bar * k.T;
  }
  static Unknown velocity_force(const Kinematics& k, const Matrix3& J_bar) {
    return -k.T.transpose() * (k.omega_bar.cross(J_bar * k.omega_bar) + J_bar * k.T_dot_rates);
  }
  static Unknown applied_force(const Kinematics& k, const Vector3& n_bar) { return k.T.transpose() * n_bar; }
  static Eigen::Matrix<S, 0, 3> internal_jacobian(const Kinematics&) { return {}; }
  static Eigen::Matrix<S, 0, 1> internal_gamma(const Kinematics&) { return {}; }
  static Matrix3 lift(const Kinematics& k) { return k.T.inverse(); }
  static Vector3 to_angular_acceleration(const Kinematics& k, const Unknown& x) {
    return k.T * x + k.T_dot_rates;
  }

  /// det T = (2 - 2 cos |phi|) / |phi|^2: 1 at the orientation A_0 of the chart, 0 after a full turn.
  static S chart_distance(const Chart&, const Coordinates& q) { return 2 * a(q.phi).value; }
  static Chart choose_chart(const trivium::ChartOptions&, const Vector4& p) { return {p}; }
  static Coordinates from_pose(const Chart& chart, const Vector4& p, const Vector3& omega_bar) {
    const Vector3 phi = trivium::rotation_vector<S>(
        trivium::multiply_parameters<S>(trivium::conjugate_parameters<S>(chart.p_0), p));
    return {phi, T(phi).inverse() * omega_bar};
  }
  static Vector4 to_euler_parameters(const Chart& chart, const Coordinates& q) {
    return trivium::multiply_parameters<S>(chart.p_0, trivium::exponential_parameters<S>(q.phi));
  }
};

static_assert(trivium::EquationsAsPrinted<RotationVector<double>>);
