#pragma once
/// From a state back to the scene that a file holds: the inverse of make_state (make_mechanism.hpp).
/// Assembled and simulated states are written by it.

#include "mechanism/mechanism_state.hpp"
#include "scenes/scene.hpp"

namespace trivium {

/// Writes poses and velocities back into a scene, rounded to double. A saved run of another state is dropped.
void set_state(scenes::Scene& scene, const MechanismState<double>& state);

}  // namespace trivium
