#pragma once
/// The reaction of a joint on one of its bodies, as a value. formulations/joint_reaction.hpp computes it from
/// lambda; here are only its components and their change of point or frame.

#include "bodies/rotations/so3.hpp"

namespace trivium {

/// What a joint does to one of its bodies: force and torque about `point`, all in the same frame.
template <class Scalar>
struct Reaction {
  Vector3<Scalar> force = Vector3<Scalar>::Zero();   ///< [N]
  Vector3<Scalar> torque = Vector3<Scalar>::Zero();  ///< [N m], about `point`
  Vector3<Scalar> point = Vector3<Scalar>::Zero();   ///< [m]

  /// The same reaction about another point.
  Reaction about(const Vector3<Scalar>& other) const {
    return {force, torque + (point - other).cross(force), other};
  }
  /// The same reaction in the components of a frame at the global origin with rotation A (frame to global).
  Reaction in_frame(const Matrix3<Scalar>& A) const {
    return {A.transpose() * force, A.transpose() * torque, A.transpose() * point};
  }
};

}  // namespace trivium
