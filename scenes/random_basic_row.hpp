#pragma once
/// Draws a basic constraint of any type at random, in global vectors and points. Random scenes
/// (random_scene.hpp) take their basic constraints from here.

#include "constraints/basic_constraint.hpp"
#include "scenes/random_draw.hpp"
#include "scenes/side.hpp"

namespace trivium::scenes {

/// Smallest distance of a drawn row from its singularity: the sine of the angle between the vectors of a dp1,
/// and the distance [m] between the points of a d. The condition number kappa would not show such a
/// singularity, since rows are scaled to unit size first. 0.2 is chosen by experiment.
inline constexpr double far_from_singular = 0.2;

/// The parts of a drawn basic constraint.
struct RandomBasicRow {
  Side i, j;            ///< vectors and points in global components; `body` is not set
  Vector3 direction{};  ///< global vector of the constraint, if its type has one
  double f = 0;         ///< value of the row's function f at time t for which the row is satisfied
};

/// A random basic constraint of this type at time t. Its points, if it has points, are P on body i and Q on
/// body j. Its vectors are drawn around x on body i and around y on body j.
RandomBasicRow random_basic_row(ConstraintType type, RandomDraw& draw, double t, const RandomDraw::V& P,
                                const RandomDraw::V& Q, const RandomDraw::V& x, const RandomDraw::V& y);

}  // namespace trivium::scenes
