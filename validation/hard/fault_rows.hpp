#pragma once
/// Rows about the end of runs of `trivium simulate`, for the family of faults. Their value is a number of
/// runs in which something is wrong.

#include <string>
#include <vector>

#include "scenes/scene.hpp"
#include "validation/hard/judge.hpp"

namespace trivium::hard {

using Options = std::vector<std::string>;
Options operator+(Options all, const Options& more);

/// A row about the end of a run. Its value will be the number of runs with something wrong.
Row row_of_end(const Judge& judge, const std::string& formulation, const std::string& method);

/// Adds the row of runs of which `wrong` holds what is wrong with each; empty texts do not count.
/// `announced`: whether one of them ended with a message.
void settle(Judge& judge, Row row, bool announced, std::vector<std::string> wrong, const std::string& why);

inline constexpr double onset = 0.5;  ///< time [s] at which the push begins

/// A pendulum that is pushed by the force (c t)^4 from the onset on.
scenes::Scene pushed_pendulum(double c);

}  // namespace trivium::hard
