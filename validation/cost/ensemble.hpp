#pragma once
/// One mechanism at many states: how many a second on one core.

#include <vector>

#include "validation/cost/measurement.hpp"

namespace trivium::cost {

/// The catalogue's arm of seven joints under gravity alone, at random angles and rates. Microseconds are
/// those of one state, errors the largest over some of the states.
std::vector<Measurement> measure_ensemble(const Timing& timing);

}  // namespace trivium::cost
