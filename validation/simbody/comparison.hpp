#pragma once
/// Compares one scene in every formulation with the ways of rebuilding it in Simbody. Accelerations, lambda
/// and reactions are compared as relative differences in the metric of mass_metric.hpp. If Simbody cannot
/// solve the scene, its physical twin is compared, and the result says so.

#include <string>
#include <vector>

#include "formulations/side_by_side.hpp"
#include "validation/harness/named_scene.hpp"
#include "validation/simbody/way.hpp"

namespace trivium {

/// Relative differences between one formulation and Simbody, each in the metric of mass_metric.hpp.
struct SimbodyDistance {
  std::string formulation, error;  ///< error: why the formulation has no solution
  double acceleration = 0;         ///< see acceleration_distance [-]
  double lambda = 0;               ///< see lambda_distance [-]; unique rows only
  /// Difference of the unique joint reactions and of the sum of all reactions on every body (which is always
  /// unique) [-]. Forces are divided by sqrt(m), torques about the centre of mass by sqrt(J); the scale is
  /// the larger of both solutions and the bound of accelerations.
  double reaction = 0;
};

struct SimbodyComparison {
  std::string scene;
  simbody::Way way = simbody::Way::mobilizers;
  bool possible = true;  ///< false if no joint becomes a mobilizer, so that the way `mobilizers` would only
                         ///< have free bodies
  bool twin = false;     ///< the physical twin was compared, for the reason in `refusal`
  std::string refusal;   ///< Simbody's message about the scene, or the reason why Simbody was not used
                         ///< (massless_motion.hpp)
  std::string failure;   ///< Simbody's message about the twin; then nothing was compared
  std::string error;     ///< why no formulation has a solution; then nothing was compared
  int nb = 0, nc = 0, rank = 0;
  double kappa = 1;
  int mobilizers = 0, constraint_rows = 0, idle_rows = 0;
  double pose_defect = 0;
  bool any_unique = false;      ///< at least one multiplier is unique
  bool any_constraint = false;  ///< the scene has rows, and so reactions
  std::vector<SimbodyDistance> formulations;

  /// The bound for all differences: max(1e-10, 100 u kappa). The floor 1e-10 is chosen by experiment; Simbody
  /// solves in double and does not refine its solutions.
  double bound() const;
  SimbodyDistance worst() const;
  bool compared() const { return !formulations.empty(); }
  /// solved() and agrees() are false if the way is not possible.
  bool solved() const;
  bool agrees() const;
};

std::string_view name_of(simbody::Way way);

/// Compares the scene's state in all three ways.
std::vector<SimbodyComparison> compare_with_simbody(const NamedScene& named);

}  // namespace trivium
