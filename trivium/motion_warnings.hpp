#pragma once
/// Warnings about a run: rows for which the rank tolerance decides narrowly at the start, singular positions
/// that it passed, energy that is not accounted for, constraint drift, large local errors of given steps. The
/// public interface and the program report the same warnings.

#include <string>
#include <vector>

#include "simulation/motion.hpp"

namespace trivium {

/// One sentence per warning; empty if there is nothing to warn about.
std::vector<std::string> warnings_of(const SimulationReport& report);

}  // namespace trivium
