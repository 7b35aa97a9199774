#pragma once
/// Which constraint rows are independent, which multipliers are unique, and how well the rows are
/// conditioned. A property of the mechanism at one state, not of a formulation or of a precision: decided
/// once, in double, on the tangent Jacobian, by the singular values of its rows against rank_tolerance.

#include <vector>

#include "bodies/numbers/scalar.hpp"
#include "formulations/analysis/rank_tolerance.hpp"
#include "formulations/analysis/row_norms.hpp"
#include "mechanism/model.hpp"

namespace trivium {

struct RowAnalysis : RowNorms {
  int rank = 0;
  std::vector<int> independent, dependent;  ///< rows in file order; a dependent one follows from earlier rows
  std::vector<bool> unique;                 ///< row k of null(Phi^T) is zero: lambda_k is unique
  /// nc x (nc - rank): E N is orthonormal, Phi^T N = 0, zero in unique rows. lambda is unique up to N y. A
  /// row without a gradient has no column here; its lambda acts on nothing and is 0.
  MatrixX<double> null_basis;
  /// rank x 6 nb: the coefficients c of least |Phi_independent^T c - w| for a w; empty where no row is
  /// dependent.
  MatrixX<double> combination;
  /// Dependent rows whose right side contradicts that of the rows they follow from: no acceleration satisfies
  /// all.
  std::vector<int> contradictory;
  double kappa = 1;  ///< condition number of E^-1 S E^-1 over its nonzero singular values
};

RowAnalysis analyse_rows(const TangentSystem& system);

/// The row analysis and the printed form are dense: beyond this many unknowns (6 nb + nc) they take minutes
/// and gigabytes, and are refused.
inline constexpr int most_dense_unknowns = 6000;

/// The row analysis of a model, in double; throws a ModelError that names mechanism and time. For other types
/// of constraints and effects than the library's include row_analysis_impl.hpp.
template <class Types>
RowAnalysis analyse_rows(const Model<double, Types>& model);

}  // namespace trivium
