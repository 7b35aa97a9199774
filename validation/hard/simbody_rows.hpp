#pragma once
/// Simbody's own integrators on the motions of hard cases. They stand beside; their verdicts do not count.

#include <vector>

#include "validation/hard/judge.hpp"

namespace trivium::hard {

/// One row for each of Simbody's integrators of high order, or one row that says why Simbody cannot build the
/// scene. Empty if Simbody is not installed.
std::vector<Row> simbody_rows(const Judge& judge, const HardMotion& motion, const ExactMotion& exact,
                              double accuracy);

}  // namespace trivium::hard
