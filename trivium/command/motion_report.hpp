#pragma once
/// The summary of a run of `trivium simulate`, as text and as JSON: counters of the method, drift off the
/// constraints, the balance of energy. What is warned about is decided in motion_warnings.hpp.

#include <optional>
#include <string>
#include <vector>

#include "base/json_writer.hpp"
#include "mechanism/mechanism.hpp"
#include "simulation/motion.hpp"
#include "simulation/simulate.hpp"

namespace trivium {

/// What was asked for, to which a run's report is added.
struct MotionReport {
  const Mechanism<double>& mechanism;
  double t_start;
  const SimulationOptions& options;

  std::string text(const SimulationReport& report) const;
  std::string json(const SimulationReport& report) const;
  /// Of a run that could not go on. `last`: the time of the last output; none where the motion did not begin.
  std::string failure_json(const std::optional<double>& last, const char* error) const;

 private:
  /// An object that begins with what was asked for.
  JsonWriter begin_json() const;
};

}  // namespace trivium
