#pragma once
/// The saved end of a run, in the coordinates of its formulation and with the memory of its integrator. A run
/// can be continued from it. One-step methods with given steps then give the same bits as without the
/// interruption, multistep methods and chosen steps the same motion within their tolerances. A scene saves
/// poses and twists as well.

#include <string>
#include <vector>

namespace trivium {

/// The data of a run at its end that poses and twists do not contain.
struct SavedRun {
  double t = 0;      ///< time of the state [s]
  double start = 0;  ///< start time of the first run [s]; given steps and output times are counted from it
  std::string formulation, integrator;  ///< names
  std::vector<std::string> charts;      ///< chart of each body; empty in formulations without charts
  std::vector<double> y;                ///< state vector of the integrator: positions, velocities and work
  /// Scales of speed so far, (m/s, rad/s) for each group of connected bodies: speeds that the bodies reached,
  /// or that the loads could cause.
  std::vector<double> fastest;
  std::vector<double> memory;  ///< data that the integrator keeps from step to step
  /// Largest violation of a row and of its derivative at the state [m or rad; m/s or rad/s].
  double phi = 0, phi_dot = 0;
  /// The first run began with nearly dependent rows. These rows count as independent along the whole motion.
  bool began_singular = false;
  std::vector<double> angles;  ///< last counted joint angles [rad], in the order of the effects
  bool operator==(const SavedRun&) const = default;
};

}  // namespace trivium
