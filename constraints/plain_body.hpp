#pragma once
/// The simplest coordinates that constraints can be asked about: r and the global angular velocity. No
/// formulation of the library uses them; the laws of constraints are tried in them, and a body at rest in the
/// global frame makes vectors and points global.

#include "bodies/rotations/so3.hpp"
#include "constraints/body_kinematics.hpp"

namespace trivium {

template <class S>
struct PlainBody {
  using Scalar = S;
  static constexpr int rotational_unknowns = 3;
  Vector3<S> r = Vector3<S>::Zero(), r_dot = Vector3<S>::Zero();
  Matrix3<S> A = Matrix3<S>::Identity();
  Vector3<S> omega = Vector3<S>::Zero();  ///< global components

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
