#pragma once
/// A rigid body: its mass and inertia (RigidBody), position and orientation (Pose), velocities (Twist), both
/// together (BodyMotion) and loads (Wrench). The origin of the body frame is the centre of mass. A bar marks
/// components in the body frame; vectors without a bar have global components.

#include <Eigen/Geometry>

#include "bodies/numbers/vectors.hpp"

namespace trivium {

/// Mass and inertia of a rigid body. The default is 1 kg and 1 kg m^2 about every axis.
template <class Scalar>
struct RigidBody {
  Scalar mass{1};                                         ///< m [kg]
  Matrix3<Scalar> inertia = Matrix3<Scalar>::Identity();  ///< J_bar [kg m^2], centre of mass, body frame

  /// Calls use(a.m, b.m, ...) for every member m, where a, b, ... are the given bodies.
  template <class Use, class... Part>
  static void show_parts(const Use& use, Part&... p) {
    use(p.mass...);
    use(p.inertia...);
  }
};

/// Position and orientation of a body.
template <class Scalar>
struct Pose {
  Vector3<Scalar> r = Vector3<Scalar>::Zero();   ///< centre of mass [m, global]
  Vector4<Scalar> p = Vector4<Scalar>::Unit(0);  ///< unit Euler parameters (e0, e1, e2, e3) [-]
};

/// Velocity and angular velocity of a body.
template <class Scalar>
struct Twist {
  Vector3<Scalar> r_dot = Vector3<Scalar>::Zero();      ///< velocity of the centre of mass [m/s, global]
  Vector3<Scalar> omega_bar = Vector3<Scalar>::Zero();  ///< angular velocity [rad/s, body frame]
};

/// Position and velocity of a body, independent of the coordinates of a formulation. Effects read the motion
/// of bodies in this form only (EffectView).
template <class Scalar>
struct BodyMotion {
  Vector3<Scalar> r = Vector3<Scalar>::Zero(), r_dot = Vector3<Scalar>::Zero();  ///< [m], [m/s], global
  Matrix3<Scalar> A = Matrix3<Scalar>::Identity();      ///< rotation matrix, body to global [3x3]
  Vector3<Scalar> omega_bar = Vector3<Scalar>::Zero();  ///< angular velocity [rad/s, body frame]

  /// r + A s_bar [m, global]: position of the body-fixed point s_bar [m, body frame].
  Vector3<Scalar> point(const Vector3<Scalar>& s_bar) const { return r + A * s_bar; }
  /// r' + A (omega_bar x s_bar) [m/s, global]: velocity of the body-fixed point s_bar [m, body frame].
  Vector3<Scalar> point_velocity(const Vector3<Scalar>& s_bar) const {
    return r_dot + A * omega_bar.cross(s_bar);
  }
};

/// Force and moment on a body.
template <class Scalar>
struct Wrench {
  Vector3<Scalar> F = Vector3<Scalar>::Zero();      ///< force [N, global]
  Vector3<Scalar> n_bar = Vector3<Scalar>::Zero();  ///< moment about the centre of mass [N m, body frame]

  /// Adds a force [N, global] at the body-fixed point s_bar [m, body frame] of a body with rotation matrix A.
  void add_force(const Vector3<Scalar>& force, const Matrix3<Scalar>& A, const Vector3<Scalar>& s_bar) {
    F += force;
    n_bar += s_bar.cross(A.transpose() * force);
  }
};

/// (m r' . r' + omega_bar . J_bar omega_bar) / 2 [J].
template <class Scalar>
Scalar kinetic_energy(const RigidBody<Scalar>& body, const Twist<Scalar>& twist) {
  return (body.mass * twist.r_dot.squaredNorm() + twist.omega_bar.dot(body.inertia * twist.omega_bar)) / 2;
}

}  // namespace trivium
