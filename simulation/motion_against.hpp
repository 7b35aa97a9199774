#pragma once
/// Comparison of a motion of another code with the library's motion, column by column, at the times of the
/// other motion. The bound of a column's difference, with chosen steps, is
///
///     bound = 2 . steps . tolerance . amplification of an error in this column
///
/// The factor 2 allows both codes an error of the tolerance in every step. Runs from neighbouring starts
/// (neighbouring_start.hpp) measure the amplification. With given steps, the library's part of the bound is
/// twice the change that half the step makes. The part of the other code is then still steps . tolerance .
/// amplification, with the tolerances of the options. The amplification counts as at least the size of the
/// column, and for rounding 1e-12 of this size is added to every bound.

#include <optional>
#include <string>
#include <vector>

#include "simulation/motion_comparison.hpp"
#include "simulation/other_motion.hpp"

namespace trivium {

/// One column, at the time where its difference is the largest relative to its bound.
struct ColumnAgainst {
  std::string theirs, ours;  ///< name in the other file and in the library's files
  double size = 0;           ///< largest magnitude in the library's motion, over all columns of the same kind
  double difference = 0;     ///< largest difference of any formulation, at `t`
  double t = 0, bound = 0;   ///< that time [s], and the bound there
  std::string not_judged;    ///< reason why the column has no bound; empty if it has one
  bool holds() const { return !not_judged.empty() || difference <= bound; }
};

/// The result of compare_against.
struct MotionAgainst {
  std::vector<ColumnAgainst> columns;
  std::vector<ComparedRun> runs;
  double neighbour_distance = 0;  ///< largest relative distance of a neighbouring start [-]; 0: there is none
  double judged_from = 0;         ///< first time of the other motion [s]
  /// Time [s] from which neighbouring motions have diverged, so that no bound holds; none if they never do.
  std::optional<double> judged_until;

  bool complete() const { return are_complete(runs); }
  /// False if neighbouring motions have diverged from the first time on.
  bool is_judged() const;
  /// Whether all runs are complete, something is judged, and no column exceeds its bound.
  bool holds() const;
};

/// Runs every formulation and compares it with the other motion. Throws an Error of kind input if the other
/// motion begins before the scene's time, or has no column with a bound.
MotionAgainst compare_against(const std::vector<ComparedFormulation>& formulations,
                              const Model<double>& model, const OtherMotion& other,
                              const SimulationOptions& options);

}  // namespace trivium
