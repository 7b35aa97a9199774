#pragma once
/// Does a state satisfy its constraints, and the projection of one that does not.

#include <string>
#include <vector>

#include "formulations/analysis/row_analysis.hpp"

namespace trivium {

/// How far one row is from holding: |Phi| or |Phi_q q' - nu| divided by the norm of the row's Jacobian, so
/// metres or radians (per second), whatever the scaling of the row.
struct Violation {
  std::string row;
  double residual = 0;   ///< Phi, or Phi_q q' - nu
  double size = 0;       ///< in m or rad (per second)
  double tolerance = 0;  ///< of size
  const char* unit = "";
  bool exceeds = false;
};

struct Consistency {
  std::vector<Violation> positions, velocities;  ///< every row, in order
  std::vector<std::string> wrong_branches;  ///< joints whose rows hold on a branch that is not the joint's

  bool holds() const;
  bool holds_positions() const;
  bool holds_rows() const;  ///< positions and velocities, on whatever branch
  /// The offending rows, worst first, with their residuals; empty where all holds.
  std::string report() const;
};

/// A state is consistent to 1e-8 of the scene's own lengths and speeds (and 1e-12 where nothing moves).
Consistency check_consistency(const Mechanism<double>& mechanism, const MechanismState<double>& state);

/// What to do about a wrong branch: to project is none of it.
inline constexpr const char* wrong_branch_advice =
    "a wrong branch cannot be left by projection: turn the body or the axis in the file";

/// Projects positions, then velocities, onto the constraints: to the state nearest the given one,
/// displacements and rotation vectors weighted by mass and inertia; redundant rows are allowed. Throws a
/// ModelError naming the rows that cannot be met together.
MechanismState<double> assemble(const Mechanism<double>& mechanism, MechanismState<double> state);

/// The velocity part alone.
void project_velocities(const Mechanism<double>& mechanism, MechanismState<double>& state);

}  // namespace trivium
