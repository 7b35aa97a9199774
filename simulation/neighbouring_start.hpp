#pragma once
/// A start near that of a motion, for the measurement of how the motion amplifies small differences. Its
/// distance is about a hundred tolerances. It is large beside the errors of the runs, and small enough that
/// the effect is proportional to the distance. If no state can be projected at this distance, a smaller
/// distance is tried.

#include "mechanism/model.hpp"

namespace trivium {

/// A state near the start of a motion.
struct NeighbouringStart {
  MechanismState<double> state;  ///< satisfies the constraints
  /// The largest difference of a body's position, orientation, velocity or angular velocity, relative to the
  /// lengths and speeds of the mechanism [-]. 0 if the constraints leave no neighbour, as in a mechanism
  /// without degrees of freedom.
  double distance = 0;
};

/// Largest relative difference of two motions that counts as proportional to the difference of their starts.
/// Motions that differ more have diverged. The value is a safety factor: the terms of second order, which the
/// proportion neglects, are then about a tenth of those of first order.
inline constexpr double small_difference = 0.1;

/// The default distance of a neighbour, as a multiple of the tolerance. The first distance tried is at least
/// 1e-11 and at most 1e-4.
inline constexpr double distance_in_tolerances = 100;

/// How many neighbours measure an amplification. A single neighbour may lie in a direction that a motion
/// hardly amplifies, as near a singular position. 3 is a compromise: the fewer neighbours, the more likely
/// all of them miss the direction of strong amplification; every further neighbour costs a run.
inline constexpr int neighbours = 3;

/// A random neighbour at about the distance tolerance . in_tolerances [-]. Seeds 1, 2, ... give different
/// directions. On one platform a seed always gives the same neighbour. The structured solver projects it onto
/// the constraints, which costs as much as a step. Throws an Error if no neighbour can be projected at three
/// distances, each 30 times smaller than the one before.
NeighbouringStart neighbouring_start(const Model<double>& model, double tolerance, int seed = 1,
                                     double in_tolerances = distance_in_tolerances);

/// 4 sin(theta / 4) [rad] for the angle theta between the orientations p and q (unit Euler parameters, whose
/// signs do not matter). For small angles this is theta, up to theta^3 / 96.
double turn_between(const Vector4<double>& p, const Vector4<double>& q);

}  // namespace trivium
