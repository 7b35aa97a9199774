#pragma once
/// Writes a state back into a scene: the inverse of make_state (make_mechanism.hpp). Used to write assembled
/// and simulated states to scene files.

#include "mechanism/mechanism_state.hpp"
#include "scenes/scene.hpp"

namespace trivium {

/// Writes poses and velocities into the scene as doubles, and removes the saved run, which belongs to another
/// state.
void set_state(scenes::Scene& scene, const MechanismState<double>& state);

}  // namespace trivium
