#pragma once
/// From a scene to the plain data that Simbody's side reads. Signs and factors of multipliers stand in
/// multiplier_signs.hpp, the other way in simbody_solution.hpp.

#include "mechanism/model.hpp"
#include "scenes/scene.hpp"
#include "validation/simbody/model.hpp"

namespace trivium {

/// The scene's state, taken as the state at time t.
simbody::Model to_simbody(const scenes::Scene& scene, double t);
/// The same where its model has been made already.
simbody::Model to_simbody(const scenes::Scene& scene, const Model<double>& made);

}  // namespace trivium
