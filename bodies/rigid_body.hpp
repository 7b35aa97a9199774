#pragma once
/// A rigid body (mass, inertia), how it moves (pose, twist, motion) and how it is loaded (wrench). The body
/// frame sits at the centre of mass. A bar means body components, no bar global ones.

#include <Eigen/Geometry>

#include "bodies/numbers/vectors.hpp"

namespace trivium {

/// m [kg] and Jbar [kg m^2], the inertia tensor about the centre of mass in the body frame.
template <class Scalar>
struct RigidBody {
  Scalar mass{1};
  Matrix3<Scalar> inertia = Matrix3<Scalar>::Identity();

  /// use(part...) for every part of one body or of several side by side.
  template <class Use, class... Part>
  static void show_parts(const Use& use, Part&... p) {
    use(p.mass...);
    use(p.inertia...);
  }
};

/// r [m, global]: centre of mass. p [-]: unit Euler parameters, e0 first.
template <class Scalar>
struct Pose {
  Vector3<Scalar> r = Vector3<Scalar>::Zero();
  Vector4<Scalar> p = Vector4<Scalar>::Unit(0);
};

/// r' [m/s, global] and omega_bar [rad/s, body frame].
template <class Scalar>
struct Twist {
  Vector3<Scalar> r_dot = Vector3<Scalar>::Zero();
  Vector3<Scalar> omega_bar = Vector3<Scalar>::Zero();
};

/// What an effect may see of a body: position and velocity in any formulation's own numbers.
template <class Scalar>
struct BodyMotion {
  Vector3<Scalar> r = Vector3<Scalar>::Zero(), r_dot = Vector3<Scalar>::Zero();
  Matrix3<Scalar> A = Matrix3<Scalar>::Identity();
  Vector3<Scalar> omega_bar = Vector3<Scalar>::Zero();

  /// The global position of the body-fixed point s_bar.
  Vector3<Scalar> point(const Vector3<Scalar>& s_bar) const { return r + A * s_bar; }
  /// The global velocity of the body-fixed point s_bar.
  Vector3<Scalar> point_velocity(const Vector3<Scalar>& s_bar) const {
    return r_dot + A * omega_bar.cross(s_bar);
  }
};

/// Force F [N, global] and moment nbar about the centre of mass [N m, body frame].
template <class Scalar>
struct Wrench {
  Vector3<Scalar> F = Vector3<Scalar>::Zero();
  Vector3<Scalar> n_bar = Vector3<Scalar>::Zero();

  /// A global force at the body-fixed point s_bar of a body with rotation A.
  void add_force(const Vector3<Scalar>& force, const Matrix3<Scalar>& A, const Vector3<Scalar>& s_bar) {
    F += force;
    n_bar += s_bar.cross(A.transpose() * force);
  }
};

/// Translational and rotational kinetic energy [J] of one body.
template <class Scalar>
Scalar kinetic_energy(const RigidBody<Scalar>& body, const Twist<Scalar>& twist) {
  return (body.mass * twist.r_dot.squaredNorm() + twist.omega_bar.dot(body.inertia * twist.omega_bar)) / 2;
}

}  // namespace trivium
