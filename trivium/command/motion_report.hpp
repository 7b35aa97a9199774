#pragma once
/// The summary of a run of `trivium simulate`, as text and as JSON: counters of the method, constraint drift,
/// energy balance. motion_warnings.hpp decides the warnings.

#include <optional>
#include <string>
#include <vector>

#include "base/json_writer.hpp"
#include "mechanism/mechanism.hpp"
#include "simulation/motion.hpp"
#include "simulation/simulate.hpp"
#include "simulation/step_verification.hpp"

namespace trivium {

/// The mechanism, start time [s] and options of a run. The functions write them together with the report of
/// the run.
struct MotionReport {
  const Mechanism<double>& mechanism;
  double t_start;
  const SimulationOptions& options;

  /// `verified`: the errors that --verify found.
  std::string text(const SimulationReport& report, const std::vector<ErrorByHalving>& verified = {}) const;
  std::string json(const SimulationReport& report, const std::vector<ErrorByHalving>& verified = {}) const;
  /// The summary of a run that ended with an error. `last` is the time of the last output [s], if any.
  std::string failure_json(const std::optional<double>& last, const char* error) const;

 private:
  /// A JSON object that begins with the request.
  JsonWriter begin_json() const;
};

}  // namespace trivium
