#pragma once
/// What could cause lambda if nothing cancelled: bounds of Q, gamma and the rows' gradients in a tangent
/// system, by magnitudes alone. Decides in what unit a lambda is measured that is left of terms which cancel.

#include "formulations/analysis/tangent_system.hpp"

namespace trivium {

/// Sets the magnitudes of Q and gamma in a tangent system: every part of a force and of gamma by its own,
/// omega_bar by its norm. In a fast spin about an axis of symmetry Q and gamma vanish, but r-p carries
/// |omega_bar|^2 / 4 in its unknowns all the same, and its rounding is of that size; where c is nearly along
/// a lever, so is that of every formulation's gradient.
template <class Types>
void add_magnitude_bounds(const Mechanism<double, Types>& mechanism, const MechanismState<double>& state,
                          TangentSystem& system);

}  // namespace trivium
