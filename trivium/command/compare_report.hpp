#pragma once
/// What `trivium compare` says of one motion in several formulations, as text, JSON, CSV and a figure. Which
/// bounds there are is simulation/motion_comparison.hpp's to decide.

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
  /// Draws to an SVG file.
  void plot(const std::string& file) const;

 private:
  std::string verdict_along() const;
  std::string verdict_at_states() const;
  std::string runs_table() const;
  std::string instants_table() const;
};

}  // namespace trivium
