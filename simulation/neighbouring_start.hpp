#pragma once
/// A start beside a motion's own, by which the motion's own sensitivity is measured. Decides how far it is: a
/// hundred tolerances, far enough for the errors of runs not to matter, near enough for what the motion makes
/// of it to be in proportion; nearer where it cannot be assembled there.

#include "mechanism/model.hpp"

namespace trivium {

struct NeighbouringStart {
  MechanismState<double> state;  ///< meets the constraints
  /// The largest difference of a body's place, turn, velocity or angular velocity, relative to the
  /// mechanism's own lengths and speeds; 0 where the constraints leave no neighbour.
  double distance = 0;
};

/// Relative, up to which what a difference of the start makes is in proportion to it: beyond, motions have
/// parted.
inline constexpr double small_difference = 0.1;

/// So many tolerances away, but no farther than 1e-4, which is no neighbour any more.
inline constexpr double distance_in_tolerances = 100;

/// Drawn with a fixed seed. Throws a ModelError where none can be assembled.
NeighbouringStart neighbouring_start(const Model<double>& model, double tolerance,
                                     double in_tolerances = distance_in_tolerances);

/// Twice the sine of half the angle between two orientations [rad]; p and -p are one.
double turn_between(const Vector4<double>& p, const Vector4<double>& q);

}  // namespace trivium
