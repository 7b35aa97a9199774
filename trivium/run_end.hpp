#pragma once
/// From the end of a run to a scene that another goes on from. The library's own sources include this.

#include "scenes/scene.hpp"
#include "simulation/motion.hpp"

namespace trivium {

/// The scene in which the run began becomes that in which it ended, with its numbers and its full turns.
void set_end(scenes::Scene& scene, const RunEnd& end);

}  // namespace trivium
