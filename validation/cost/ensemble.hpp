#pragma once
/// Solves one mechanism at many states and measures the time per state on one core. Controllers and
/// optimisers call a solver in this way; engines may therefore solve several states at once.

#include <vector>

#include "validation/cost/measurement.hpp"

namespace trivium::cost {

/// The catalogue's arm of seven joints under gravity, at `states` random angles and rates, rounded up to
/// whole portions. Every engine solves one portion before the next is drawn. The time in microseconds is per
/// state, and the median over the portions; errors are the largest over some of the states.
std::vector<Measurement> measure_ensemble(int states);

}  // namespace trivium::cost
