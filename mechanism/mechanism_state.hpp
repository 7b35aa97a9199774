#pragma once
/// The state of a mechanism: pose and velocities of every body at one time. It is given by r, p, r' and
/// omega_bar, independently of the formulation; every formulation computes its coordinates from it.

#include <vector>

#include "bodies/rigid_body.hpp"

namespace trivium {

/// Poses and velocities of all bodies at one time.
template <class Scalar>
struct MechanismState {
  Scalar t{0};                       ///< time [s]
  std::vector<Pose<Scalar>> pose;    ///< one per body, without the ground
  std::vector<Twist<Scalar>> twist;  ///< one per body, without the ground
};

}  // namespace trivium
