#pragma once
/// What an error costs: of all runs of one motion, the least CPU time that reaches an error of positions, by
/// contender and in a table. Decides from which error on a reference is not known well enough to tell.

#include <string>
#include <vector>

#include "validation/precision/runs.hpp"

namespace trivium::precision {

/// All runs of one scene's motion, and the reference that their errors are measured against.
struct SceneResult {
  std::string scene;
  double t_end, reference_error;
  bool is_trusted;
  std::vector<RunResult> runs;
};

/// The contender whose run it is: the method and its formulation, or the engine and its method.
std::string who(const RunSettings& settings);
/// Whether another engine ran it.
bool is_peer(const RunSettings& settings);

/// For errors of positions from 1e-3 m down: the cheapest run of each contender, then ours beside the peers',
/// then the runs that failed.
std::string cost_table(const SceneResult& result);

}  // namespace trivium::precision
