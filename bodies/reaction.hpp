#pragma once
/// The reaction of a joint on one of its bodies, as a value. formulations/joint_reaction.hpp computes it from
/// the multipliers lambda; this file has its components and the change of reference point or frame.

#include "bodies/rotations/so3.hpp"

namespace trivium {

/// Force and torque of a joint on one of its bodies. All three vectors are components in the same frame.
template <class Scalar>
struct Reaction {
  Vector3<Scalar> force = Vector3<Scalar>::Zero();   ///< [N]
  Vector3<Scalar> torque = Vector3<Scalar>::Zero();  ///< about `point` [N m]
  Vector3<Scalar> point = Vector3<Scalar>::Zero();   ///< reference point of the torque [m]

  /// The equivalent reaction with reference point `other` [m].
  Reaction about(const Vector3<Scalar>& other) const {
    return {force, torque + (point - other).cross(force), other};
  }
  /// The same reaction with components in another frame, for a reaction with global components. The origin of
  /// that frame is the global origin. A [3x3] maps components in that frame to global components.
  Reaction in_frame(const Matrix3<Scalar>& A) const {
    return {A.transpose() * force, A.transpose() * torque, A.transpose() * point};
  }
};

}  // namespace trivium
