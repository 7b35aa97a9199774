#pragma once
/// Which constraint rows are independent, which multipliers are unique, and how well the rows are
/// conditioned. This is a property of the mechanism at one state, not of a formulation or a precision. It is
/// decided once, in double, by the pivots of a QR factorisation of the scaled tangent Jacobian, relative to
/// rank_tolerance.

#include <string>
#include <vector>

#include "bodies/numbers/scalar.hpp"
#include "formulations/analysis/rank_tolerance.hpp"
#include "formulations/analysis/row_norms.hpp"
#include "mechanism/model.hpp"

namespace trivium {

/// A row near the rank tolerance. `share` [-] is the pivot of the row in the QR factorisation of the scaled
/// Jacobian, relative to the largest pivot: the part of the row's gradient that is independent of the rows
/// eliminated before it. It is within a factor 100 of the tolerance.
struct NarrowRow {
  int row = 0;
  double share = 0, tolerance = standard_rank_tolerance;
  bool counts() const { return share > tolerance; }  ///< as independent
};

/// The result of the analysis; rows in file order.
struct RowAnalysis : RowNorms {
  int rank = 0;
  std::vector<int> independent, dependent;  ///< a dependent row is a combination of independent rows
  std::vector<bool> unique;  ///< lambda_k is unique: row k has a gradient, and row k of null_basis is 0
  /// Basis N of the null space of Phi^T, one column per dependent row with a gradient: Phi^T N = 0, E N has
  /// orthonormal columns. lambda is determined up to N y. The multiplier of a row without a gradient has no
  /// effect and is 0.
  MatrixX<double> null_basis;
  /// [rank x 6 nb] Maps a generalized force w to the coefficients c of the independent rows for which
  /// |Phi_independent^T c - w| is smallest. This norm is in the geometric scaling
  /// (mechanism/rank_tolerance.hpp): moments are divided by the mean lever. Empty if no row is dependent.
  MatrixX<double> combination;
  /// Dependent rows whose right side contradicts the rows that they are a combination of: no acceleration
  /// satisfies them all.
  std::vector<int> contradictory;
  std::vector<NarrowRow> narrow;      ///< by falling shares; not known from the structured solver
  std::vector<std::string> warnings;  ///< one sentence per narrow row, if the names of the rows are known
  double kappa = 1;  ///< condition number of E^-1 S E^-1 over its nonzero singular values [-]
};

/// The row analysis of a tangent system. Contradictory rows are reported in the result and are no error here.
/// Throws a ModelError if the metric is singular (MassMetric) or the dependent rows cannot be chosen.
RowAnalysis analyse_rows(const TangentSystem& system);

/// One sentence for each narrow row, which says what keeps the row or leaves it out. `least_tolerance` is the
/// smallest rank tolerance that a user may set.
std::vector<std::string> narrow_row_warnings(const std::vector<std::string>& row_names,
                                             const RowAnalysis& rows,
                                             double least_tolerance = least_rank_tolerance);

/// Largest number of unknowns (6 nb + nc) for the dense row analysis and the printed form. Larger problems
/// take minutes and gigabytes and are refused.
inline constexpr int most_dense_unknowns = 6000;

/// The row analysis of a model, in double. Throws a ModelError that names the mechanism: if there are too
/// many unknowns or, also with the time, if the metric is singular or rows contradict each other. For other
/// types of constraints and effects include row_analysis_impl.hpp.
template <class Types>
RowAnalysis analyse_rows(const Model<double, Types>& model);

/// A motion that changes one row while the other rows hold, with rotations in metres by the geometric scaling
/// (mechanism/rank_tolerance.hpp).
struct FreeMotion {
  /// The rate of the row along this motion: the size of the part of its gradient that the other rows leave
  /// free [unit of the row per m]. It falls to 0 where the row becomes dependent, as that of a driver does at
  /// a dead point or at the end of its reach.
  double gradient = 0;
  VectorX<double> q_dot;  ///< [6 nb], as the columns of Phi; 0 if the gradient is 0
};
/// The motion that changes a row fastest while the other rows hold.
FreeMotion free_motion(const TangentSystem& system, int row);

/// The second derivative of the row along the path that begins with its free motion. `gamma` holds the right
/// sides of all rows at the velocities q_dot of this motion, without their functions of time.
double free_curvature(const TangentSystem& system, int row, const VectorX<double>& gamma);

}  // namespace trivium
