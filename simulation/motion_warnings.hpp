#pragma once
/// Warnings about a run: rows for which the rank tolerance decides narrowly at the start, singular positions
/// that it passed, energy that is not accounted for, constraint drift, large local errors of given steps. The
/// public interface and the program report the same warnings.

#include <string>
#include <vector>

#include "simulation/motion.hpp"

namespace trivium {

/// A warning about a run.
struct MotionWarning {
  std::string text;  ///< one sentence
  /// The size of the error that the warning states, relative to the size, the speed or the kinetic energy of
  /// the motion [-]; 0 if it states none.
  double relative_error = 0;
};

/// The warnings of a run; empty if there is nothing to warn about.
std::vector<MotionWarning> motion_warnings(const SimulationReport& report);

/// Their texts.
std::vector<std::string> warnings_of(const SimulationReport& report);

}  // namespace trivium
