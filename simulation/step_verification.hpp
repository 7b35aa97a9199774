#pragma once
/// The error of a motion with given steps of length h, by Richardson's extrapolation. The motion is repeated
/// with h/2 and h/4. If the error of x is C h^p, then
///
///     x_h - x_h/2 = (1 - 2^-p) C h^p,     |x_h - x_h/2| / |x_h/2 - x_h/4| = 2^p
///
/// The first difference gives the error, the ratio of both the observed order p. Where the observed order is
/// not that of the method, the steps are too long for the expansion of the error, or too short for the digits
/// of double, and the figure is not reliable.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "simulation/simulate.hpp"

namespace trivium {

/// The largest error of one quantity at an output.
struct ErrorByHalving {
  std::string quantity, unit;
  double error = 0;  ///< estimated error of the motion with step h [unit]
  double t = 0;      ///< of the output with the largest error [s]
  /// The order observed there; none if the differences are rounding errors, which hide it.
  std::optional<double> order = {};
  int expected_order = 0;  ///< of the method

  /// Whether the observed order is the method's, to 0.3, a tolerance chosen by experiment.
  bool is_reliable() const { return !order || std::abs(*order - expected_order) < 0.3; }
};

/// Repeats the motion of `options` (with given steps) with half and with a quarter of the step, and compares
/// the outputs, or about a hundred states if `options` has no output_step. Returns the errors of positions
/// [m], orientations [rad], velocities [m/s], angular velocities [rad/s] and of unique multipliers [unit of
/// the row]. Throws what simulate() throws.
std::vector<ErrorByHalving> verify_steps(const Model<double>& model, const SimulationOptions& options);

}  // namespace trivium
