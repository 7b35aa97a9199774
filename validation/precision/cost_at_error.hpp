#pragma once
/// The cost of accuracy: the least CPU time with which a method reaches a given error of positions. The
/// reference must be ten times as accurate as this error; otherwise nothing is reported.

#include <string>
#include <vector>

#include "validation/precision/runs.hpp"

namespace trivium::precision {

/// All runs of the motion of one scene, and the accuracy of the reference that their errors refer to.
struct SceneResult {
  std::string scene;
  double t_end, reference_error;
  bool is_trusted;
  std::vector<RunResult> runs;
};

/// The name under which a run is listed: method and formulation, or engine and method for another engine.
std::string who(const RunSettings& settings);
/// Whether the run is by another engine.
bool is_peer(const RunSettings& settings);

/// The table for the errors in position_targets: the cheapest run of each method, then Trivium's best
/// compared with Simbody's best, then the failed runs.
std::string cost_table(const SceneResult& result);

}  // namespace trivium::precision
