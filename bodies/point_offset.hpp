#pragma once
/// The vector from a point of one body to a point of another, and its rate. The order of the sums is decided
/// here: the parts that both ends share are subtracted first, so a large common distance leaves no rounding
/// of its size.

#include "bodies/rigid_body.hpp"

namespace trivium {

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

}  // namespace trivium
