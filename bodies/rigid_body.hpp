#pragma once
/// A rigid body and how it moves. The body frame sits at the centre of mass.

#include <cmath>

#include "bodies/numbers/scalar.hpp"
#include "bodies/rotations/so3.hpp"

namespace trivium {

/// m [kg] and Jbar [kg m^2], the inertia tensor about the centre of mass in the body frame.
template <class Scalar>
struct RigidBody {
  Scalar mass{1};
  Matrix3<Scalar> inertia = Matrix3<Scalar>::Identity();
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

/// (to + arm_j) - (from + arm_i), summed from the largest part down: a distance that both ends share leaves
/// no rounding of its size, be it one of the centres or an arm (the ground's points are all arm).
template <class Scalar>
Vector3<Scalar> offset_between(const Vector3<Scalar>& from, const Vector3<Scalar>& arm_i,
                               const Vector3<Scalar>& to, const Vector3<Scalar>& arm_j) {
  const Vector3<Scalar> d = to - from;
  if (arm_i.squaredNorm() > arm_j.squaredNorm()) return (d - arm_i) + arm_j;
  return (d + arm_j) - arm_i;
}

/// d = (r_j + A_j s_j) - (r_i + A_i s_i): from a point of i to one of j.
template <class Scalar>
Vector3<Scalar> point_offset(const BodyMotion<Scalar>& i, const Vector3<Scalar>& s_bar_i,
                             const BodyMotion<Scalar>& j, const Vector3<Scalar>& s_bar_j) {
  return offset_between<Scalar>(i.r, i.A * s_bar_i, j.r, j.A * s_bar_j);
}

/// Its time derivative, the velocities of the centres subtracted first.
template <class Scalar>
Vector3<Scalar> point_offset_rate(const BodyMotion<Scalar>& i, const Vector3<Scalar>& s_bar_i,
                                  const BodyMotion<Scalar>& j, const Vector3<Scalar>& s_bar_j) {
  return (j.r_dot - i.r_dot) + (j.A * j.omega_bar.cross(s_bar_j) - i.A * i.omega_bar.cross(s_bar_i));
}

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
