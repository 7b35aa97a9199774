#pragma once
/// From a scene to the plain data that Simbody's side reads.

#include "scenes/scene.hpp"
#include "validation/simbody/model.hpp"

namespace trivium {

/// The scene's state, taken as the state at time t.
simbody::Model to_simbody(const scenes::Scene& scene, double t);

}  // namespace trivium
