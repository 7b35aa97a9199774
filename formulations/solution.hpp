#pragma once
/// What every formulation answers, in the same physical terms: accelerations r'' and omega_bar', and
/// multipliers lambda. Answers of different formulations are compared in these.

#include <vector>

#include "bodies/rotations/so3.hpp"

namespace trivium {

/// The solution of the equations of motion at one state.
template <class Scalar>
struct PhysicalSolution {
  std::vector<Vector3<Scalar>> r_ddot;         ///< [m/s^2, global]
  std::vector<Vector3<Scalar>> omega_bar_dot;  ///< [rad/s^2, body frame]
  VectorX<Scalar> lambda;                      ///< one per row; non-unique ones of minimum |E lambda|
};

}  // namespace trivium
