#pragma once
/// r-d: a formulation whose rotational coordinates are three directors d_1, d_2, d_3, the columns of A. A
/// body has nine such numbers and six internal rows d_i . d_j = delta_ij; the unknowns are r'' and the second
/// derivatives of the directors. These are the natural coordinates of a body with one point (Garcia de Jalon
/// and Bayo, Kinematic and Dynamic Simulation of Multibody Systems, 1994). The mass matrix is constant, and
/// there are no velocity-dependent inertia forces. lambda is the same as in all other formulations. The
/// multipliers lambda_internal of the six internal rows belong to this formulation alone.
///
/// The rotational mass matrix is mass_block = E (x) I with E = tr(J_bar) / 2 I - J_bar, the second moments of
/// mass.

#include <bodies/rigid_body.hpp>
#include <bodies/rotations/so3.hpp>
#include <formulations/contract/equations_as_printed.hpp>

template <class S>
struct Directors {
  using Scalar = S;
  using Vector3 = trivium::Vector3<S>;
  using Vector4 = trivium::Vector4<S>;
  using Matrix3 = trivium::Matrix3<S>;
  using Unknown = trivium::Vector<S, 9>;
  using Chart = trivium::NoChart;

  static constexpr std::string_view name = "r-d";
  static constexpr int rotational_unknowns = 9;
  static constexpr int internal_constraints = 6;

  struct Coordinates {
    Matrix3 A = Matrix3::Identity(), A_dot = Matrix3::Zero();
  };

  /// The three columns of M as one vector [9x1].
  static Unknown stack(const Matrix3& M) { return Eigen::Map<const Unknown>(M.data()); }
  /// The vector w for which tilde(w) is the skew-symmetric part of M.
  static Vector3 axial(const Matrix3& M) {
    return Vector3(M(2, 1) - M(1, 2), M(0, 2) - M(2, 0), M(1, 0) - M(0, 1)) / 2;
  }

  struct Kinematics : trivium::BodyMotion<S> {
    using Scalar = S;
    static constexpr int rotational_unknowns = 9;
    Matrix3 A_dot;

    /// a = A a_bar is linear in the directors: the bias, the last member, is zero.
    trivium::BodyVector<S> vector(const Vector3& a_bar) const {
      return {a_bar, this->A * a_bar, A_dot * a_bar, Vector3::Zero()};
    }
    trivium::Matrix<S, 3, 9> jacobian(const trivium::BodyVector<S>& v) const {
      trivium::Matrix<S, 3, 9> B;
      for (int k = 0; k < 3; ++k) B.template middleCols<3>(3 * k) = v.a_bar[k] * Matrix3::Identity();
      return B;
    }
    trivium::Matrix<S, 1, 9> jacobian_along(const trivium::BodyVector<S>& v, const Vector3& w) const {
      return w.transpose() * jacobian(v);
    }
  };
  static Kinematics kinematics(const Chart&, const Vector3& r, const Vector3& r_dot, const Coordinates& q) {
    return {{r, r_dot, q.A, axial(q.A.transpose() * q.A_dot)}, q.A_dot};
  }

  static trivium::Matrix<S, 9, 9> mass_block(const Kinematics&, const Matrix3& J_bar) {
    const Matrix3 E = J_bar.trace() / 2 * Matrix3::Identity() - J_bar;
    trivium::Matrix<S, 9, 9> M;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) M.template block<3, 3>(3 * i, 3 * j) = E(i, j) * Matrix3::Identity();
    return M;
  }
  static Unknown velocity_force(const Kinematics&, const Matrix3&) { return Unknown::Zero(); }
  /// The generalized force of a moment n: half of n x d_i on each director d_i. In a rotation with omega
  /// their power is the sum of n x d_i . (omega x d_i) / 2 = n . omega, the power of the moment.
  static Unknown applied_force(const Kinematics& k, const Vector3& n_bar) {
    return stack(k.A * trivium::tilde(n_bar)) / 2;
  }

  // internal rows: (d_i . d_i - 1) / 2 for i = j, and d_i . d_j for i < j
  template <class Visit>
  static void for_each_pair(const Visit& visit) {
    for (int i = 0, row = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) visit(row++, i, j);
  }
  static trivium::Matrix<S, 6, 9> internal_jacobian(const Kinematics& k) {
    trivium::Matrix<S, 6, 9> P = trivium::Matrix<S, 6, 9>::Zero();
    for_each_pair([&](int row, int i, int j) {
      P.template block<1, 3>(row, 3 * i) = k.A.col(j).transpose();
      P.template block<1, 3>(row, 3 * j) = k.A.col(i).transpose();
    });
    return P;
  }
  static trivium::Vector<S, 6> internal_gamma(const Kinematics& k) {
    trivium::Vector<S, 6> gamma;
    for_each_pair(
        [&](int row, int i, int j) { gamma[row] = (i == j ? -1 : -2) * k.A_dot.col(i).dot(k.A_dot.col(j)); });
    return gamma;
  }

  // A'' = A tilde(omega_bar') + A tilde(omega_bar)^2, and lift is the factor of omega_bar'
  static trivium::Matrix<S, 9, 3> lift(const Kinematics& k) {
    trivium::Matrix<S, 9, 3> L;
    for (int n = 0; n < 3; ++n) L.col(n) = stack(k.A * trivium::tilde(Vector3(Vector3::Unit(n))));
    return L;
  }
  static Vector3 to_angular_acceleration(const Kinematics& k, const Unknown& x) {
    return axial(k.A.transpose() * Eigen::Map<const Matrix3>(x.data()));
  }

  static S chart_distance(const Chart&, const Coordinates&) { return S(1); }
  static Chart choose_chart(const trivium::ChartOptions&, const Vector4&) { return {}; }
  static Coordinates from_pose(const Chart&, const Vector4& p, const Vector3& omega_bar) {
    const Matrix3 A = trivium::rotation_matrix(p);
    return {A, A * trivium::tilde(omega_bar)};
  }
  static Vector4 to_euler_parameters(const Chart&, const Coordinates& q) {
    return trivium::euler_parameters(q.A);
  }
};

static_assert(trivium::EquationsAsPrinted<Directors<double>>);
