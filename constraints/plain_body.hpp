#pragma once
/// The simplest kinematics of a body for constraints: r and the global angular velocity omega. No formulation
/// of the library uses this type. The laws of constraints are tested with it, and a PlainBody at rest in the
/// global frame lets constraint code take points and vectors in global components.

#include "bodies/rotations/so3.hpp"
#include "constraints/body_kinematics.hpp"

namespace trivium {

/// Unknowns r'' and omega' [global]: a' = omega x a, bias = omega x (omega x a), B = -tilde(a).
template <class S>
struct PlainBody {
  using Scalar = S;
  static constexpr int rotational_unknowns = 3;
  Vector3<S> r = Vector3<S>::Zero(), r_dot = Vector3<S>::Zero();  ///< centre of mass [m], [m/s], global
  Matrix3<S> A = Matrix3<S>::Identity();                          ///< rotation matrix, body to global
  Vector3<S> omega = Vector3<S>::Zero();                          ///< angular velocity [rad/s, global]

  BodyVector<S> vector(const Vector3<S>& a_bar) const {
    const Vector3<S> a = A * a_bar, rate = omega.cross(a);
    return {a_bar, a, rate, omega.cross(rate)};
  }
  Matrix3<S> jacobian(const BodyVector<S>& v) const { return -tilde<S>(v.a); }
  Matrix<S, 1, 3> jacobian_along(const BodyVector<S>& v, const Vector3<S>& w) const {
    return v.a.cross(w).transpose();
  }
};
static_assert(BodyKinematics<PlainBody<double>>);

}  // namespace trivium
