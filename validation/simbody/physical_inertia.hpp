#pragma once
/// A scene whose bodies any multibody code accepts. Codes refuse inertias that no body has, or that no motion
/// about an axis resists; those bodies get more inertia, the others stay as they are.

#include "scenes/scene.hpp"

namespace trivium {

/// The same scene with J + eps I in place of every inertia J that is not positive definite or breaks the
/// triangle inequality, with its principal moments J1 <= J2 <= J3:
///
///   eps = max(0, J3 - J1 - J2) + (trace(J) + m s^2) / 100
///
/// and s the body's largest distance from its centre of mass to a point that a constraint or spring takes
/// (1 m if there is none and J = 0). Other bodies stay as they are.
scenes::Scene physical_twin(scenes::Scene scene);

}  // namespace trivium
