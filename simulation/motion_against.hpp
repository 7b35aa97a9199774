#pragma once
/// A motion of another code beside the library's, column by column, at the other's times. Decides the bound:
/// both may err by the tolerance in every step, and what the motion makes of an error in a column is measured
/// by a run from a neighbouring start (neighbouring_start.hpp), as along the motion of several formulations.

#include <optional>
#include <string>
#include <vector>

#include "simulation/motion_comparison.hpp"
#include "simulation/other_motion.hpp"

namespace trivium {

struct ColumnAgainst {
  std::string theirs, ours;
  double size = 0;          ///< the largest magnitude of the library's, of all columns of this kind
  double difference = 0;    ///< the largest of a formulation, at `t`
  double t = 0, bound = 0;  ///< of the output where the difference is the largest beside its bound
  std::string not_judged;   ///< why there is no bound; empty where there is
  bool holds() const { return !not_judged.empty() || difference <= bound; }
};

struct MotionAgainst {
  std::vector<ColumnAgainst> columns;
  std::vector<ComparedRun> runs;
  double neighbour_distance = 0;
  std::optional<double> judged_until;  ///< from here on a neighbouring start has led elsewhere

  bool complete() const { return are_complete(runs); }
  bool holds() const;
};

/// In each of the formulations. Throws an Error of kind input where the other's times begin before the
/// scene's.
MotionAgainst compare_against(const std::vector<ComparedFormulation>& formulations,
                              const Model<double>& model, const OtherMotion& other,
                              const SimulationOptions& options);

}  // namespace trivium
