#pragma once
/// From the front door's settings to the library's options of a run. The library's own sources include this.

#include <string>
#include <vector>

#include "simulation/motion_comparison.hpp"
#include "trivium/simulate.hpp"

namespace trivium {

/// Throws an Error of kind input for a name that there is not.
SimulationOptions simulation_options(const SimulateSettings& settings);

/// Those of these names (all where there are none) that go with the integrator. Throws an Error of kind input
/// where fewer than `least`, one or two, are left.
std::vector<ComparedFormulation> formulations_to_compare(const std::vector<std::string>& names,
                                                         const std::string& integrator,
                                                         std::size_t least = 2);

}  // namespace trivium
