#pragma once
/// The state of a mechanism: pose and velocity of every body at a time. It stands in terms that no
/// formulation owns (r, Euler parameters p, r', omega_bar), and every formulation makes its coordinates from
/// it.

#include <vector>

#include "bodies/rigid_body.hpp"

namespace trivium {

/// Pose and velocity of all bodies at time t: the state that every formulation starts from.
template <class Scalar>
struct MechanismState {
  Scalar t{0};
  std::vector<Pose<Scalar>> pose;
  std::vector<Twist<Scalar>> twist;
};

}  // namespace trivium
