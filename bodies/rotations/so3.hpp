#pragma once
/// Rotations as matrices A [3x3], Euler parameters p = (e0, e) [4, -] and rotation vectors phi [3, rad], and
/// the maps between them:
///
///     A = E G^T = exp(tilde(phi)),   p = (cos(|phi|/2), sin(|phi|/2) phi/|phi|),   omega_bar = 2 G p'
///
/// A maps body components (with a bar) to global components. Haug, Computer Aided Kinematics and Dynamics
/// (1989), chapter 9. Two conventions are fixed here: euler_parameters returns, of p and -p, the one whose
/// component of largest magnitude is positive; rotation_vector returns a vector with |phi| <= pi.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "bodies/numbers/vectors.hpp"

namespace trivium {

/// tilde(a) [3x3], skew-symmetric: tilde(a) b = a x b.
template <class Scalar>
Matrix3<Scalar> tilde(const Vector3<Scalar>& a) {
  Matrix3<Scalar> m;
  m << Scalar(0), -a.z(), a.y(), a.z(), Scalar(0), -a.x(), -a.y(), a.x(), Scalar(0);
  return m;
}

/// e0 I + tilde(e) [3x3], which E and the derivative B(p, a_bar) of A a_bar by p have in common.
template <class Scalar>
Matrix3<Scalar> euler_parameter_block(const Vector4<Scalar>& p) {
  Matrix3<Scalar> block;
  block.col(0) = Vector3<Scalar>(p[0], p[3], -p[2]);
  block.col(1) = Vector3<Scalar>(-p[3], p[0], p[1]);
  block.col(2) = Vector3<Scalar>(p[2], -p[1], p[0]);
  return block;
}

/// E = [-e, e0 I + tilde(e)] [3x4]: global omega = 2 E p'. Haug (1989), section 9.3.
template <class Scalar>
Matrix<Scalar, 3, 4> E_matrix(const Vector4<Scalar>& p) {
  Matrix<Scalar, 3, 4> E;
  E.col(0) = -p.template tail<3>();
  E.template rightCols<3>() = euler_parameter_block(p);
  return E;
}

/// G = [-e, e0 I - tilde(e)] [3x4]: omega_bar = 2 G p'. Haug (1989), section 9.3.
template <class Scalar>
Matrix<Scalar, 3, 4> G_matrix(const Vector4<Scalar>& p) {
  Matrix<Scalar, 3, 4> G;
  G.col(0) = -p.template tail<3>();
  G.template rightCols<3>() = euler_parameter_block(p).transpose();
  return G;
}

/// A = E G^T [3x3], body to global; p must have norm 1.
template <class Scalar>
Matrix3<Scalar> rotation_matrix(const Vector4<Scalar>& p) {
  return E_matrix(p) * G_matrix(p).transpose();
}

/// Euler parameters of a rotation matrix A [3x3]: |p| = 1, the component of largest magnitude is positive.
/// Well conditioned for every A, since only this component, at least 1/2, is divided by.
template <class Scalar>
Vector4<Scalar> euler_parameters(const Matrix3<Scalar>& A) {
  using std::sqrt;
  const Scalar trace = A.trace();
  Vector4<Scalar> squares(1 + trace, 1 + 2 * A(0, 0) - trace, 1 + 2 * A(1, 1) - trace,
                          1 + 2 * A(2, 2) - trace);
  Eigen::Index k;
  squares.maxCoeff(&k);
  Vector4<Scalar> p;  // row k of the symmetric matrix 4 p p^T, whose entries are sums of entries of A
  const Vector3<Scalar> skew(A(2, 1) - A(1, 2), A(0, 2) - A(2, 0), A(1, 0) - A(0, 1));
  if (k == 0) {
    p << squares[0], skew;
  } else {
    p[0] = skew[k - 1];
    for (int m = 0; m < 3; ++m) p[m + 1] = m == k - 1 ? squares[k] : A(m, k - 1) + A(k - 1, m);
  }
  return p / p.norm();
}

/// The unit vector of coordinate axis k.
template <class Scalar>
Vector3<Scalar> unit_axis(int k) {
  return Vector3<Scalar>::Unit(k);
}

/// R_k(angle) [3x3]: rotation by `angle` [rad] about coordinate axis k (0 = x, 1 = y, 2 = z).
template <class Scalar>
Matrix3<Scalar> axis_rotation(int k, const Scalar& angle) {
  using std::cos, std::sin;
  const Scalar c = cos(angle), s = sin(angle);
  const int m = (k + 1) % 3, n = (k + 2) % 3;
  Matrix3<Scalar> R = Matrix3<Scalar>::Identity();
  R(m, m) = c;
  R(n, n) = c;
  R(m, n) = -s;
  R(n, m) = s;
  return R;
}

/// M tilde(a) [rows x 3], column by column; uses only the first three entries of a.
template <class Scalar, int rows, int size>
Matrix<Scalar, rows, 3> times_tilde(const Matrix<Scalar, rows, 3>& M, const Vector<Scalar, size>& a) {
  Matrix<Scalar, rows, 3> product;
  product.col(0) = M.col(1) * a[2] - M.col(2) * a[1];
  product.col(1) = M.col(2) * a[0] - M.col(0) * a[2];
  product.col(2) = M.col(0) * a[1] - M.col(1) * a[0];
  return product;
}

/// Unit Euler parameters of exp(tilde(phi)), the rotation by |phi| [rad] about phi. Exact for phi = 0.
template <class Scalar>
Vector4<Scalar> exponential_parameters(const Vector3<Scalar>& phi) {
  using std::cos, std::sin;
  const Scalar half = phi.norm() / 2;
  Vector4<Scalar> p;
  // sin(x)/x needs no series for small x: the relative error of sin(x) is of size u for every x
  const Scalar sinc = half == Scalar(0) ? Scalar(1) : Scalar(sin(half) / half);
  p << Scalar(cos(half)), (sinc / 2) * phi;
  return p / p.norm();
}

/// Product of two rotations (quaternion product): A(result) = A(p) A(q).
template <class Scalar>
Vector4<Scalar> multiply_parameters(const Vector4<Scalar>& p, const Vector4<Scalar>& q) {
  Vector4<Scalar> out;
  const Vector3<Scalar> e = p.template tail<3>(), d = q.template tail<3>();
  out << p[0] * q[0] - e.dot(d), p[0] * d + q[0] * e + e.cross(d);
  return out;
}

/// The inverse rotation: A(result) = A(p)^T.
template <class Scalar>
Vector4<Scalar> conjugate_parameters(const Vector4<Scalar>& p) {
  return {p[0], -p[1], -p[2], -p[3]};
}

/// phi [rad], |phi| <= pi, with exp(tilde(phi)) = A(p). p and -p give the same phi if |phi| < pi.
template <class Scalar>
Vector3<Scalar> rotation_vector(const Vector4<Scalar>& p) {
  using std::atan2;
  const Vector3<Scalar> e = p[0] < Scalar(0) ? Vector3<Scalar>(-p.template tail<3>()) : p.template tail<3>();
  const Scalar sine = e.norm(), cosine = p[0] < Scalar(0) ? Scalar(-p[0]) : p[0];
  return sine > Scalar(0) ? Vector3<Scalar>(2 * atan2(sine, cosine) / sine * e) : Vector3<Scalar>(2 * e);
}

/// phi' = T(phi)^-1 omega_bar [rad/s], for A = A_0 exp(tilde(phi)) with angular velocity omega_bar [rad/s,
/// body frame]. Requires |phi| < 2 pi, where T becomes singular.
///
///     T^-1 = I + 1/2 tilde(phi) + (1 - x cot x) / |phi|^2 tilde(phi)^2,   x = |phi| / 2
template <class Scalar>
Vector3<Scalar> rotation_vector_rate(const Vector3<Scalar>& phi, const Vector3<Scalar>& omega_bar) {
  using std::abs, std::cos, std::sin;
  const Scalar squared = phi.squaredNorm() / 4;
  Scalar share;
  if (squared < Scalar(0.25)) {
    // Power series of sin x - x cos x, divided by x^3: the terms of first order of the closed form would
    // cancel. From x = 1/2 on the cancellation costs about one digit, and the closed form is used.
    Scalar sum = Scalar(1) / 3, power = Scalar(1) / 6, sine = 1 - squared / 6, term = -squared / 6;
    for (int k = 2; abs(power) > sum * std::numeric_limits<Scalar>::epsilon(); ++k) {
      power *= -squared / Scalar((2 * k) * (2 * k + 1));
      term *= -squared / Scalar((2 * k) * (2 * k + 1));
      sum += Scalar(2 * k) * power;
      sine += term;
    }
    share = sum / sine / 4;
  } else {
    using std::sqrt;
    const Scalar x = sqrt(squared);
    share = (1 - x * cos(x) / sin(x)) / (4 * squared);
  }
  const Vector3<Scalar> turned = phi.cross(omega_bar);
  return omega_bar + turned / 2 + share * phi.cross(turned);
}

}  // namespace trivium
