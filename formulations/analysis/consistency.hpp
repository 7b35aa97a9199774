#pragma once
/// Checks whether a state satisfies its constraints: the positions and velocities of every row within
/// tolerances relative to the length and the speed of the mechanism, and every joint on the branch that its
/// type requires. (The rows of a joint also hold on other branches, for example with antiparallel axes.)

#include <string>
#include <vector>

#include "formulations/equations_of_motion.hpp"
#include "formulations/r_omega.hpp"

namespace trivium {

/// The violation of one row: |Phi| or |Phi_q q' - nu| divided by a norm of the row's gradient. For a row of a
/// length the rotational part of the gradient is first divided by the length of the mechanism (Extent), so
/// that both parts have one unit. A row of an angle has a rotational part only, which is not divided. The
/// violation is in metres or radians (per second), whatever the scale factor of the row.
struct RowViolation {
  std::string row;       ///< name
  double residual = 0;   ///< Phi, or Phi_q q' - nu
  double size = 0;       ///< violation [m or rad (per second)]
  double tolerance = 0;  ///< largest accepted size
  const char* unit = "";
  bool exceeds = false;  ///< whether size is above the tolerance, or NaN
};

/// The largest size of the violations; 0 if there are none.
double worst_size(const std::vector<RowViolation>& violations);

/// The result of check_consistency().
struct Consistency {
  std::vector<RowViolation> positions, velocities;  ///< every row, in order
  std::vector<std::string> wrong_branches;          ///< joints on a wrong branch, with the reason

  bool holds() const;            ///< positions, velocities and branches
  bool holds_positions() const;  ///< positions and branches
  bool holds_rows() const;       ///< positions and velocities, on any branch
  /// The violated rows with their residuals, largest first, and the wrong branches; empty if the state is
  /// consistent.
  std::string report() const;
};

/// The joints that are on another branch than their type requires, each with the reason. `joints` are those
/// of a mechanism, `state` is one of its states.
std::vector<std::string> wrong_branches(const std::vector<Joint<double>>& joints,
                                        const MechanismState<double>& state);

/// Checks a state. The tolerance of a row of a length is 1e-8 times the length of the mechanism for the
/// position. For the velocity it is 1e-8 times the speed of the mechanism plus 1e-12 times its length per
/// second. For a row of an angle both are divided by the length: 1e-8 rad, and 1e-8 speed / length + 1e-12
/// rad/s. Throws a ModelError if an effect is not defined at this state.
Consistency check_consistency(const Mechanism<double>& mechanism, const MechanismState<double>& state);

/// The length and the speed of a mechanism, to which its rounding errors are relative. `length` is the
/// largest distance of a centre of mass from the global origin or of a joint point from its body's origin
/// [m], and 1 m if all are 0. `speed` is the largest velocity, or angular velocity times length [m/s].
struct Extent {
  double length = 0, speed = 0;
};
/// The extent of a mechanism at a state.
Extent extent_of(const Mechanism<double>& mechanism, const MechanismState<double>& state);

/// Phi_q q' - nu of every row [unit of Phi per second].
VectorX<double> velocity_residual(const EquationsOfMotion<ROmega<double>>& eom);

}  // namespace trivium
