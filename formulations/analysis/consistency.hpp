#pragma once
/// Checks whether a state satisfies its constraints: the positions and velocities of every row within 1e-8
/// of the lengths and speeds of the scene, and every joint on the branch that its type requires. (The rows
/// of a joint also hold on other branches, for example with antiparallel axes.)

#include <string>
#include <vector>

#include "formulations/equations_of_motion.hpp"
#include "formulations/r_omega.hpp"

namespace trivium {

/// The violation of one row: |Phi| or |Phi_q q' - nu| divided by the norm of the row's Jacobian. This gives
/// metres or radians (per second), whatever the scale factor of the row.
struct RowViolation {
  std::string row;
  double residual = 0;   ///< Phi, or Phi_q q' - nu
  double size = 0;       ///< violation [m or rad (per second)]
  double tolerance = 0;  ///< largest accepted size
  const char* unit = "";
  bool exceeds = false;
};

/// The largest size of the violations; 0 if there are none.
double worst_size(const std::vector<RowViolation>& violations);

struct Consistency {
  std::vector<RowViolation> positions, velocities;  ///< every row, in order
  std::vector<std::string> wrong_branches;          ///< joints on a wrong branch, with the reason

  bool holds() const;
  bool holds_positions() const;
  bool holds_rows() const;  ///< positions and velocities, on any branch
  /// The violated rows with their residuals, largest first, and the wrong branches; empty if the state is
  /// consistent.
  std::string report() const;
};

/// Checks a state. The tolerance of a position is 1e-8 times the length of the scene. The tolerance of a
/// velocity is 1e-8 times the speed of the scene plus 1e-12 times its length per second.
Consistency check_consistency(const Mechanism<double>& mechanism, const MechanismState<double>& state);

/// The length and the speed of a scene, to which its rounding errors are relative. `length` is the largest
/// distance of a centre of mass from the global origin or of a joint point from its body's origin [m], and 1
/// m if all are 0. `speed` is the largest velocity, or angular velocity times length [m/s].
struct Extent {
  double length = 0, speed = 0;
};
Extent extent_of(const Mechanism<double>& mechanism, const MechanismState<double>& state);

/// Phi_q q' - nu of every row [m/s, rad/s, times the scale of the row].
VectorX<double> velocity_residual(const EquationsOfMotion<ROmega<double>>& eom);

}  // namespace trivium
