#pragma once
/// A basic constraint drawn at random in global vectors and points, whatever its type: how random scenes come
/// by theirs.

#include "constraints/basic_constraint.hpp"
#include "scenes/random_draw.hpp"
#include "scenes/side.hpp"

namespace trivium::scenes {

/// Parallel vectors of a dp1 and coincident points of a d are singularities of that one row; its scaling to
/// unit size hides them from kappa, so rows are drawn this far from them [sine; m].
inline constexpr double far_from_singular = 0.2;

struct RandomBasicRow {
  Side i, j;  ///< vectors and points, global; bodies are not set
  Vector3 direction{};
  double f = 0;  ///< that meets the row at t
};

/// Where a row has points they are P and Q; vectors are drawn about x, one of body j about y.
RandomBasicRow random_basic_row(ConstraintType type, RandomDraw& draw, double t, const RandomDraw::V& P,
                                const RandomDraw::V& Q, const RandomDraw::V& x, const RandomDraw::V& y);

}  // namespace trivium::scenes
