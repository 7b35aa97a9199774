#pragma once
/// The solution of any formulation in the same physical terms, so that solutions of different formulations
/// can be compared: accelerations r'' and omega_bar', and multipliers lambda.

#include <vector>

#include "bodies/rotations/so3.hpp"

namespace trivium {

/// The solution of the equations of motion at one state.
template <class Scalar>
struct PhysicalSolution {
  std::vector<Vector3<Scalar>> r_ddot;         ///< [m/s^2, global]
  std::vector<Vector3<Scalar>> omega_bar_dot;  ///< [rad/s^2, body frame]
  VectorX<Scalar> lambda;  ///< one per row; multipliers that are not unique have minimum |E lambda|
};

}  // namespace trivium
