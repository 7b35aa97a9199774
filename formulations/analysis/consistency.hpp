#pragma once
/// Does a state satisfy its constraints? Decides whether the position and the velocity of every row hold
/// within 1e-8 of the scene's own lengths and speeds, and whether every joint is on the branch that its type
/// names.

#include <string>
#include <vector>

#include "formulations/equations_of_motion.hpp"
#include "formulations/r_omega.hpp"

namespace trivium {

/// How far one row is from holding: |Phi| or |Phi_q q' - nu| divided by the norm of the row's Jacobian, so
/// metres or radians (per second), whatever the scaling of the row.
struct RowViolation {
  std::string row;
  double residual = 0;   ///< Phi, or Phi_q q' - nu
  double size = 0;       ///< in m or rad (per second)
  double tolerance = 0;  ///< of size
  const char* unit = "";
  bool exceeds = false;
};

double worst_size(const std::vector<RowViolation>& violations);

struct Consistency {
  std::vector<RowViolation> positions, velocities;  ///< every row, in order
  std::vector<std::string> wrong_branches;  ///< joints whose rows hold on a branch that is not the joint's

  bool holds() const;
  bool holds_positions() const;
  bool holds_rows() const;  ///< positions and velocities, on whatever branch
  /// The offending rows, worst first, with their residuals; empty where all holds.
  std::string report() const;
};

/// A state is consistent to 1e-8 of the scene's own lengths and speeds (and 1e-12 where nothing moves).
Consistency check_consistency(const Mechanism<double>& mechanism, const MechanismState<double>& state);

/// The largest coordinate of any body or joint point, and the largest speed: what rounding scales with.
struct Extent {
  double length = 0, speed = 0;
};
Extent extent_of(const Mechanism<double>& mechanism, const MechanismState<double>& state);

/// Phi_q q' - nu of every row.
VectorX<double> velocity_residual(const EquationsOfMotion<ROmega<double>>& eom);

}  // namespace trivium
