#pragma once
/// States that say nothing about the formulations, because what could cause lambda cancels in them.

#include "formulations/row_analysis.hpp"

namespace trivium {

/// Whether |E^-1 b|, b = |Phi| M^-1 |Q| + |gamma|, is less than a tenth of the same with every part of a
/// force and of gamma taken by its magnitude. There the data's own rounding exceeds u |E^-1 b|, in whose
/// units lambda is measured.
/// Also where rows contradict each other, so that no acceleration exists.
bool causes_cancel(const Mechanism<double>& mechanism, const MechanismState<double>& state);

}  // namespace trivium
