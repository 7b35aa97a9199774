#pragma once
/// One mechanism at many states: how many a second on one core. This is how controllers and optimisers call a
/// solver, so engines that take many states at once may.

#include <vector>

#include "validation/cost/measurement.hpp"

namespace trivium::cost {

/// The catalogue's arm of seven joints under gravity alone, at so many random angles and rates, rounded up to
/// whole portions. Every engine goes through a portion, then the next is drawn; microseconds are the median
/// over the portions, of one state; errors the largest over some of the states.
std::vector<Measurement> measure_ensemble(int states);

}  // namespace trivium::cost
