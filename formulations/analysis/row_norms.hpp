#pragma once
/// The norms in which lambda and accelerations are measured, and what could cause them, at one state. No rank
/// is decided here and no condition number: those are row_analysis.hpp and condition_number.hpp.

#include "formulations/analysis/mass_metric.hpp"

namespace trivium {

struct RowNorms {
  VectorX<double> E;   ///< diag(S)^(1/2), S = Phi M^-1 Phi^T: the norm of lambda, independent of units and of
                       ///< row scaling
  VectorX<double> mu;  ///< see MassMetric

  VectorX<double> schur_rhs_bound;  ///< b = |Phi| M^-1 |Q| + |gamma|
  /// The same in which nothing cancels (magnitude_bounds.hpp); empty: not known.
  VectorX<double> schur_rhs_bound_uncancelled;
  VectorX<double> acceleration_scale;  ///< square root of the metric's diagonal, 6 nb
  double acceleration_bound = 0;  ///< the size of accelerations that Q and gamma could cause, in the metric
};

/// Where all that could cause lambda cancels, b is at least this share of what it would be if it did not:
/// what is left then is rounding, and no unit to measure lambda in.
inline constexpr double cancellation_floor = 1e-8;

/// W = L^-1 Phi^T, where the metric is L L^T: the norms of its columns are E.
RowNorms row_norms(const TangentSystem& system, const MassMetric& metric, const MatrixX<double>& W);

/// 1 / v, and 0 where v is 0: the inverse of a row's norm, where a row may be without a gradient.
VectorX<double> inverse_or_zero(const VectorX<double>& v);

}  // namespace trivium
