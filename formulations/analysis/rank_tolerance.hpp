#pragma once
/// Every tolerance that decides whether a row of constraints is dependent, and so the rank, side by side, for
/// the analysis and for the solver along the graph. The
/// analysis of a mechanism (row_analysis.hpp) decides once, in double, by singular values. The solver along
/// the graph (structured/) decides at every state, in its own Scalar, by sines between rows and by pivots.
/// Both find the same rank: a sine is compared with the same number as a singular value, and a pivot, which
/// is the square of a sine, only says which rows are to be asked one by one.

#include <cmath>

#include "bodies/numbers/lanewise.hpp"
#include "bodies/numbers/scalar.hpp"

namespace trivium {

// singular values and sines

/// The singular values of the geometrically scaled Jacobian below which a row counts as dependent. It sits
/// between the defect that rounded or nearly consistent positions leave in a dependent row (1e-16 to 1e-9)
/// and the smallest singular value of a real mechanism. Neighbour: direction_tolerance.
inline constexpr double rank_tolerance = 1e-8;

/// The same for the solver along the graph: a row is dependent where the sine between its direction and those
/// of the other rows is no larger. In a narrow Scalar rounding alone makes larger sines than rank_tolerance.
template <class S>
S direction_tolerance() {
  return larger(S(100 * unit_roundoff<S>()), S(rank_tolerance));
}

/// The sine between the two vectors of a dp1 below which its row vanishes, as where the angle that it drives
/// turns back. Near the root of near_singular_pivot, so that both see the same singular position.
inline constexpr double vanishing_row_tolerance = 1e-5;

/// Of the dependent rows the last in the file are taken whose part of the null space, beside that of those
/// taken before, is at least this share; a tenth of it as often as that finds too few, down to the least.
inline constexpr double null_space_share = 0.1, least_null_space_share = 1e-12;

// pivots of closings, squares of sines weighed by inertia

/// The pivot, as a share of what it was before other rows went, up to which a row counts as dependent until
/// it is asked by itself (direction_tolerance). Above it one refinement makes up for the pivot's own
/// rounding; and no row that misplaced points alone make independent comes near it, unless its motion has
/// next to no inertia. A sine of 1e-4: not rank_tolerance, though the digits are the same.
template <class S>
S dependent_pivot() {
  return larger(S(1000 * unit_roundoff<S>()), S(1e-8));
}

/// The same for DependentRows::detect_near_singular, and as a share of what it was made of. A motion passes a
/// singular position on a row whose sine is the root of this, so that what the row then is not asked is its
/// square. Neighbour: vanishing_row_tolerance.
template <class S>
S near_singular_pivot() {
  return static_cast<S>(std::pow(largest_lane(unit_roundoff<S>()), 0.6));
}

/// The pivot, as a share of what it was made of, that is rounding.
template <class S>
S pivot_rounding() {
  return S(30 * unit_roundoff<S>());
}

/// A dependent row is restored where the energy of the motion that it forces is more than this many times
/// that of what one more refinement changes: a motion of rounding does not last.
inline constexpr double least_energy_above_rounding = 100;

/// The pivot of a body's own block, in the motions that its joint leaves, as a share of what it was made of,
/// that is rounding: those motions have no inertia. Of a point link half of that, whose blocks are made of
/// less.
template <class S>
S inertia_rounding() {
  return S(16 * unit_roundoff<S>());
}

// pivots of the rows of one joint, sines

/// The share of a joint's row beside those before it up to which it counts as dependent: what it does to the
/// parent is the square of its inverse, which above this leaves the parent's other motions half of their
/// digits. Rows between this and direction_tolerance are asked one by one.
template <class S>
S joint_row_tolerance() {
  using std::sqrt;
  return sqrt(sqrt(larger(unit_roundoff<S>(), S(1e-32))));
}

/// The share of a joint's row beside those before it that is rounding.
template <class S>
S joint_row_rounding() {
  return S(100 * unit_roundoff<S>());
}

// right sides of dependent rows

/// A dependent row contradicts the others where its right side misses theirs by more than this, relative to
/// the terms of gamma: well above what inconsistent positions within their tolerance can leave.
inline constexpr double contradiction_tolerance = 1e-6;

/// The same for the solver along the graph: positions there are within its direction_tolerance.
template <class S>
S contradiction_tolerance_in() {
  return larger(S(contradiction_tolerance), S(30 * direction_tolerance<S>()));
}

/// What velocities of rounding size leave of a right side contradicts nothing.
inline constexpr double contradiction_floor = 1e-12;

/// A solution misses a dependent row by no more than this share of the row's terms where refinement has come
/// to its end; where it misses more, dependent rows are asked one by one.
template <class S>
S row_rounding() {
  return S(8 * unit_roundoff<S>());
}

/// The share of contradiction_tolerance_in up to which a row needs no closer look at the sizes of its terms.
inline constexpr double share_without_doubt = 1e-3;

}  // namespace trivium
