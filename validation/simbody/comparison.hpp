#pragma once
/// One scene in every formulation against the ways of rebuilding it in Simbody. Compared are accelerations,
/// lambda and reactions, each relative and in the metric of mass_metric.hpp; what Simbody cannot solve is
/// compared as its physical twin, and said so.

#include <string>
#include <vector>

#include "formulations/side_by_side.hpp"
#include "validation/harness/named_scene.hpp"
#include "validation/simbody/way.hpp"

namespace trivium {

/// One formulation's distance from Simbody, relative, each in the metric of mass_metric.hpp.
struct SimbodyDistance {
  std::string formulation, error;  ///< error: why the formulation has no answer
  double acceleration = 0;         ///< acceleration_distance
  double lambda = 0;               ///< lambda_distance, unique rows only
  /// Unique joint reactions and the sum of all reactions on every body (always unique), forces over sqrt(m)
  /// and torques about the centre of mass over sqrt(J), relative to the larger of them and what could cause
  /// them.
  double reaction = 0;
};

struct SimbodyComparison {
  std::string scene;
  simbody::Way way = simbody::Way::mobilizers;
  bool possible = true;  ///< false in the way of mobilizers where no joint becomes one: the bodies are free
  bool twin = false;     ///< the physical twin is compared, because
  std::string refusal;   ///< Simbody said this of the scene, or is not asked (massless_motion.hpp)
  std::string failure;   ///< Simbody said this of the twin: nothing is compared
  std::string error;     ///< why no formulation has an answer: nothing is compared
  int nb = 0, nc = 0, rank = 0;
  double kappa = 1;
  int mobilizers = 0, constraint_rows = 0, idle_rows = 0;
  double pose_defect = 0;
  bool any_unique = false;      ///< some lambda is
  bool any_constraint = false;  ///< some reaction is
  std::vector<SimbodyDistance> formulations;

  /// max(1e-10, 100 u kappa).
  double bound() const;
  SimbodyDistance worst() const;
  bool compared() const { return !formulations.empty(); }
  /// Both are false where the way is not possible.
  bool solved() const;
  bool agrees() const;
};

std::string_view name_of(simbody::Way way);

/// The scene's state in all three ways.
std::vector<SimbodyComparison> compare_with_simbody(const NamedScene& named);

}  // namespace trivium
