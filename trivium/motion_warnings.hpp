#pragma once
/// What of a run deserves a warning: singular positions passed, energy that is not accounted for, drift off
/// the constraints. The front door and the program say the same.

#include <string>
#include <vector>

#include "simulation/motion.hpp"

namespace trivium {

std::vector<std::string> warnings_of(const SimulationReport& report);

}  // namespace trivium
