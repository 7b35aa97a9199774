#pragma once
/// Makes a scene that any multibody code accepts. Codes refuse inertias that no body can have, or that resist
/// no motion about an axis. Bodies with such inertias get more inertia.

#include "scenes/scene.hpp"

namespace trivium {

/// The physical twin of a scene: J + eps I replaces every inertia J that is not positive definite or breaks
/// the triangle inequality. With the principal moments J1 <= J2 <= J3,
///
///   eps = max(0, J3 - J1 - J2) + (trace(J) + m s^2) / 100
///
/// where s [m] is the largest distance from the centre of mass to a point of a constraint or spring on this
/// body; if s = 0 and J = 0, eps = m (1 m)^2 / 100. Other bodies stay unchanged. 1/100 is a compromise: a
/// smaller share makes the mass matrix worse conditioned, a larger one changes the motion more.
scenes::Scene physical_twin(scenes::Scene scene);

}  // namespace trivium
