#pragma once
/// Conversion of the public settings of a run to the library's options. For the library's own sources.

#include <string>
#include <vector>

#include "simulation/motion_comparison.hpp"
#include "trivium/simulate.hpp"

namespace trivium {

/// The options of a run. Throws an Error of kind input for an unknown name or a number out of its range. Also
/// throws if `projects` is false together with `baumgarte`: the stabilisation replaces the projection, so
/// that there is none to switch off.
SimulationOptions simulation_options(const SimulateSettings& settings);

/// The formulations among `names` (empty: among all) that the integrator can be used with. Throws an Error of
/// kind input for an unknown name, or if they are fewer than `least`, which is 1 or 2.
std::vector<ComparedFormulation> formulations_to_compare(const std::vector<std::string>& names,
                                                         const std::string& integrator,
                                                         std::size_t least = 2);

}  // namespace trivium
