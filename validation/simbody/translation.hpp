#pragma once
/// Translates a scene into the plain data of model.hpp. The opposite direction, with signs and factors of
/// multipliers, is in simbody_solution.hpp and multiplier_signs.hpp.

#include "mechanism/model.hpp"
#include "scenes/scene.hpp"
#include "validation/simbody/model.hpp"

namespace trivium {

/// The model of the scene, whose state is taken as the state at time t [s].
simbody::Model to_simbody(const scenes::Scene& scene, double t);
/// The same for a scene whose Trivium model exists already.
simbody::Model to_simbody(const scenes::Scene& scene, const Model<double>& made);

}  // namespace trivium
