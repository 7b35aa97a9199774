#pragma once
/// The report of `trivium compare` on one motion in several formulations, as text, JSON, CSV and a figure.
/// simulation/motion_comparison.hpp decides the bounds.

#include <string>
#include <vector>

#include "base/json_writer.hpp"
#include "mechanism/mechanism.hpp"
#include "simulation/motion_comparison.hpp"

namespace trivium {

struct CompareReport {
  const Mechanism<double>& mechanism;
  double t_start;
  const SimulationOptions& options;
  const MotionComparison& comparison;

  std::string text() const;
  std::string json() const;
  std::string csv() const;
  /// Draws the comparison to an SVG file. Throws a std::runtime_error if gnuplot is missing or fails.
  void plot(const std::string& file) const;

 private:
  std::string verdict_along() const;
  std::string verdict_at_states() const;
  std::string runs_table() const;
  std::string instants_table() const;
};

}  // namespace trivium
