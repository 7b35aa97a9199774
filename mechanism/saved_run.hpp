#pragma once
/// Where a run stands, in the numbers of the formulation that it was in: what a run needs to go on as if it
/// had not ended. The state in poses and twists stands beside it, for everything else.

#include <string>
#include <vector>

namespace trivium {

struct SavedRun {
  double t = 0;      ///< of the state [s]
  double start = 0;  ///< of the first run [s]: given steps and outputs are counted from there
  std::string formulation, integrator;
  std::vector<std::string> charts;  ///< per body; empty in formulations without
  std::vector<double> y;            ///< positions, velocities and work, as the integrator has them
  std::vector<double> fastest;      ///< of every part of the mechanism, [m/s] and [rad/s], so far
  std::vector<double> memory;       ///< what the method keeps from step to step
  double phi = 0, phi_dot = 0;      ///< how far the state misses its rows [m or rad, per second]
  bool began_singular = false;      ///< where rows were nearly dependent: all that are not quite count
  std::vector<double> angles;       ///< [rad], where joint angles were counted last, effect by effect
  bool operator==(const SavedRun&) const = default;
};

}  // namespace trivium
