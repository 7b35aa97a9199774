#pragma once
/// All tolerances that decide whether a constraint row is dependent, and so the rank. The analysis of a
/// mechanism (row_analysis.hpp) decides once, in double: the pivots of a QR factorisation of the scaled
/// Jacobian estimate its singular values, and the mechanism's rank_tolerance is their limit relative to the
/// largest one (mechanism/rank_tolerance.hpp). The structured solver (structured/) decides in its own
/// Scalar. Under DependentRows::detect its pivots select candidates (squares of sines in closings, sines in
/// joints of the tree), and the sine of a candidate decides. The limit is direction_tolerance, which equals
/// rank_tolerance except in float. So both find the same rank except near the limit, where it matters that
/// they average the levers of rotations differently. In most motions the pivots alone decide
/// (near_singular_pivot, joint_row_tolerance).

#include <cmath>

#include "bodies/numbers/lanewise.hpp"
#include "bodies/numbers/scalar.hpp"
#include "mechanism/rank_tolerance.hpp"

namespace trivium {

// sines of single rows

/// The rank tolerance of the structured solver: a row is dependent if the sine between its direction and the
/// space of the other rows is at most this value. In float rounding alone gives sines above the standard
/// rank_tolerance. The limit is then 100 u, since some hundred operations change a row.
template <class S>
S direction_tolerance(double rank_tolerance = standard_rank_tolerance) {
  return larger(S(100 * unit_roundoff<S>()), S(rank_tolerance));
}

/// A dp1 row has no gradient where its two vectors are parallel, as at the angles 0 and pi of a driver. Below
/// this sine between the vectors the row counts as vanishing. It is close to the square root of
/// near_singular_pivot in double (1.6e-5), so that both detect the same singular position.
inline constexpr double vanishing_row_tolerance = 1e-5;

/// Choice of the dependent rows of Phi, from the end of the file. Let z_k be row k of the null basis, which
/// belongs to row k of Phi. The part of z_k that is orthogonal to the z of the rows chosen before must exceed
/// this share of |z_k|; then row k of Phi is chosen. If too few rows are found, the search is repeated with a
/// tenth of the share, down to the least share. A share s magnifies rounding errors of the multipliers by
/// 1/s: the first share costs one digit, and the least one leaves about four digits of a double.
inline constexpr double null_space_share = 0.1,  ///< the first share
    least_null_space_share = 1e-12;              ///< the least share

// pivots of closing edges: squares of sines, weighted by inertia

/// A row of a closing becomes a candidate for a dependent row if its pivot is at most this share of the row's
/// diagonal entry before other rows were eliminated. Its sine decides later (direction_tolerance). The value
/// corresponds to a sine of 1e-4 and is unrelated to rank_tolerance, which has the same digits. The relative
/// rounding error of a larger pivot is at most u / 1e-8, which one step of iterative refinement corrects.
/// Points that are misplaced within their tolerance make a dependent row look independent. The pivot of such
/// a row is far smaller than this value, unless the bodies have almost no inertia against a force along the
/// row. In float 1000 u applies, since 1e-8 is below u there: the
/// pivots in use then keep three digits.
template <class S>
S dependent_pivot() {
  return larger(S(1000 * unit_roundoff<S>()), S(1e-8));
}

/// The same for DependentRows::detect_near_singular, relative to the magnitude of the terms of the pivot.
/// Where a motion passes a singular position, the rows whose sine is below the square root of this value are
/// left out. The relative rounding error of the smallest pivot in use is then u^0.4 (4e-7 in double). The
/// exponent 0.6 is chosen by experiment: a smaller value leaves rows out for a longer part of the motion, a
/// larger one keeps rows whose multipliers are rounding errors. See also vanishing_row_tolerance.
template <class S>
S near_singular_pivot() {
  return static_cast<S>(std::pow(largest_lane(unit_roundoff<S>()), 0.6));
}

/// A row of a closing also becomes a candidate if it has cancelled to a sine of this many times
/// direction_tolerance. Its pivot is weighted by inertia and has lost digits, so that it cannot decide. The
/// value is a safety factor: masses of a ratio up to its square do not hide a row.
inline constexpr double cancelled_candidate = 100;

/// Rows of closings with a relative pivot below this make the balance of forces inaccurate and the iterations
/// of implicit methods slow. Under detect_near_singular they are exchanged for other rows, if there are. The
/// value, a sine of 0.03, is chosen by experiment: smaller ones leave iterations that diverge.
inline constexpr double weak_pivot = 1e-3;

/// A pivot is rounding error only if it is at most this share of the magnitude of its terms. 30 is chosen by
/// experiment: a smaller value takes rounding errors for pivots, a larger one leaves rows out without need.
template <class S>
S pivot_rounding() {
  return S(30 * unit_roundoff<S>());
}

/// The response to a row is the motion under a unit force along the row. One more step of refinement corrects
/// the response. A candidate of sufficient sine is put back if the energy of its response exceeds this many
/// times the energy of the correction. If the response consists of rounding errors, the correction is as
/// large as the response. An energy is a square: 100 asks for a response ten times larger than its
/// correction.
inline constexpr double least_energy_above_rounding = 100;

/// A body is eliminated in the motions that its joint leaves free. A pivot of its block in these motions is
/// rounding error only if it is at most this share of the magnitude of its terms: the body has no inertia in
/// such a motion. 16 is about the number of
/// roundings in such a pivot. Point links use half of this value, because their blocks have fewer terms.
template <class S>
S inertia_rounding() {
  return S(16 * unit_roundoff<S>());
}

// pivots of the rows of one joint, sines

/// A row of a tree joint becomes a candidate if its largest entry, after the elimination of the rows before
/// it, is at most this share of the magnitude of its terms. Under detect_near_singular and keep_count it is
/// then dependent; detect examines its sine (examined_joint_row_tolerance); keep uses joint_row_rounding. The
/// inertia that a row passes on to the parent grows with the inverse square of the row's remainder, so at
/// u^(1/4) the other motions of the parent keep half of their digits. The lower limit 1e-32 of u, which
/// applies in quad and wider Scalars, keeps the share at standard_rank_tolerance or above.
template <class S>
S joint_row_tolerance() {
  using std::sqrt;
  return sqrt(sqrt(larger(unit_roundoff<S>(), S(1e-32))));
}

/// The same under DependentRows::detect, which examines candidates: at least the largest rank tolerance, so
/// that no row below a mechanism's tolerance escapes the examination. Larger than the above in Scalars more
/// precise than double.
template <class S>
S examined_joint_row_tolerance() {
  return larger(joint_row_tolerance<S>(), S(largest_rank_tolerance));
}

/// The remainder of a joint's row is rounding error only if it is at most this share of the magnitude of its
/// terms. 100 is about the number of operations that change a row in the elimination of six rows.
template <class S>
S joint_row_rounding() {
  return S(100 * unit_roundoff<S>());
}

// right sides of dependent rows

/// A dependent row contradicts the others if its right side differs from the value that the others imply by
/// more than this, relative to the terms of gamma. (The dense analysis takes the larger of the largest
/// gamma and the implied acceleration, and adds the rounding of the terms.) The value is far above the
/// difference that inconsistent positions within their tolerance (1e-8) can cause.
inline constexpr double contradiction_tolerance = 1e-6;

/// The same for another rank tolerance: the rows that a larger one leaves out are violated more, in
/// proportion to the tolerance.
inline double contradiction_tolerance_at(double rank_tolerance) {
  return contradiction_tolerance * larger(1.0, rank_tolerance / standard_rank_tolerance);
}

/// The same for the structured solver, whose positions are consistent to its direction_tolerance. The factor
/// 30 acts in float only, since 1e-6 is larger in wider Scalars. It is chosen by experiment: a smaller factor
/// reports rounding errors of float as contradictions, a larger one lets contradictions pass.
template <class S>
S contradiction_tolerance_in(double rank_tolerance) {
  return larger(S(contradiction_tolerance_at(rank_tolerance)), S(30 * direction_tolerance<S>()));
}

/// Absolute part of the contradiction tolerance [unit of gamma; in the dense analysis of gamma divided by the
/// norm of its row]. In a mechanism at rest all terms of gamma
/// may be zero up to rounding, so that a relative tolerance alone would compare rounding errors. The value is
/// far above the rounding errors of terms of size 1 (1e-16) and far below the accelerations of a motion.
inline constexpr double contradiction_floor = 1e-12;

/// A fully refined solution violates a dependent row by at most this share of the row's terms. A row has up
/// to 12 products and gamma: their rounding errors add up to 13 u at worst, and to about sqrt(13) u if they
/// are independent. 8 lies between these factors. A larger violation is no error: it makes the solver examine
/// the candidates. A smaller value causes this at more states, a larger one lets small contradictions pass.
template <class S>
S row_rounding() {
  return S(8 * unit_roundoff<S>());
}

/// Share of contradiction_tolerance_in below which a violation is accepted at once. Above this share the
/// violation is compared with the magnitudes of the terms of the whole mechanism. The value is chosen by
/// experiment: a larger share lets contradictions pass, a smaller one makes the comparison at more states.
inline constexpr double share_without_doubt = 1e-3;

}  // namespace trivium
