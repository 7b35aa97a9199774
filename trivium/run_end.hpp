#pragma once
/// Turns the end of a run into a scene from which another run can continue. For the library's own sources.

#include "scenes/scene.hpp"
#include "simulation/motion.hpp"

namespace trivium {

/// Moves a scene to the end of a run: sets its poses and velocities, the full turns that its springs have
/// counted, and the saved run (state vector and memory of the method) from which the next run continues.
void set_end(scenes::Scene& scene, const RunEnd& end);

}  // namespace trivium
