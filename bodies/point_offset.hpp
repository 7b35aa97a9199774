#pragma once
/// The vector from a point of body i to a point of body j, and its time derivative:
///
///     d_ij = (r_j + A_j s_bar_j) - (r_i + A_i s_bar_i)
///
/// The order of the additions is chosen so that large parts common to both ends cancel first. A large
/// distance of both bodies from the origin then causes no rounding error of its size.

#include "bodies/rigid_body.hpp"

namespace trivium {

/// (to + arm_j) - (from + arm_i) [m, global], where `from` and `to` are the centres of mass of bodies i and j
/// and each arm is A s_bar. The longer arm is added to the difference of the centres first: the centre of the
/// ground is the origin, so the arm of a ground point is its whole position.
template <class Scalar>
Vector3<Scalar> offset_between(const Vector3<Scalar>& from, const Vector3<Scalar>& arm_i,
                               const Vector3<Scalar>& to, const Vector3<Scalar>& arm_j) {
  const Vector3<Scalar> d = to - from;
  if (arm_i.squaredNorm() > arm_j.squaredNorm()) return (d - arm_i) + arm_j;
  return (d + arm_j) - arm_i;
}

/// d_ij [m, global] from the point s_bar_i of body i to the point s_bar_j of body j [m, body frames].
template <class Scalar>
Vector3<Scalar> point_offset(const BodyMotion<Scalar>& i, const Vector3<Scalar>& s_bar_i,
                             const BodyMotion<Scalar>& j, const Vector3<Scalar>& s_bar_j) {
  return offset_between<Scalar>(i.r, i.A * s_bar_i, j.r, j.A * s_bar_j);
}

/// The time derivative of d_ij [m/s, global]; the velocities of the centres are subtracted first.
template <class Scalar>
Vector3<Scalar> point_offset_rate(const BodyMotion<Scalar>& i, const Vector3<Scalar>& s_bar_i,
                                  const BodyMotion<Scalar>& j, const Vector3<Scalar>& s_bar_j) {
  return (j.r_dot - i.r_dot) + (j.A * j.omega_bar.cross(s_bar_j) - i.A * i.omega_bar.cross(s_bar_i));
}

}  // namespace trivium
