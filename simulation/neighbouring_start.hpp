#pragma once
/// A start near that of a motion, to measure how the motion amplifies small differences. Its distance is
/// about a hundred tolerances. That is far enough for the errors of the runs not to matter, and near enough
/// for the effect to be proportional to the distance. If no state can be assembled at that distance, a nearer
/// one is tried.

#include "mechanism/model.hpp"

namespace trivium {

struct NeighbouringStart {
  MechanismState<double> state;  ///< satisfies the constraints
  /// The largest difference of a body's position, orientation, velocity or angular velocity, relative to the
  /// lengths and speeds of the mechanism [-]. 0 if the constraints leave no neighbour, as in a mechanism
  /// without degrees of freedom.
  double distance = 0;
};

/// The relative difference of two motions up to which it counts as proportional to the difference of their
/// starts. Beyond it the motions have diverged.
inline constexpr double small_difference = 0.1;

/// The default distance in tolerances; the first distance tried is at least 1e-11 and at most 1e-4.
inline constexpr double distance_in_tolerances = 100;

/// A random neighbour, drawn with a fixed seed, so that runs can be repeated. Throws a ModelError if no
/// neighbour can be assembled at three distances, each 30 times smaller than the one before.
NeighbouringStart neighbouring_start(const Model<double>& model, double tolerance,
                                     double in_tolerances = distance_in_tolerances);

/// 4 sin(theta / 4), for small angles theta [rad], of the angle theta between two orientations p and q.
double turn_between(const Vector4<double>& p, const Vector4<double>& q);

}  // namespace trivium
