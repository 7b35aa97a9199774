#pragma once
/// The norms of lambda and accelerations at one state, and their sizes if Q and gamma enter by magnitude.
/// Rank and condition number are computed in row_analysis.hpp and condition_number.hpp.

#include "formulations/analysis/mass_metric.hpp"

namespace trivium {

/// Weights and magnitudes at one state; nc rows, nb bodies. M stands for the metric of MassMetric.
struct RowNorms {
  /// diag(S)^(1/2), S = Phi_q M^-1 Phi_q^T: |E lambda| does not depend on units or on the scale of a row.
  VectorX<double> E;
  VectorX<double> mu;  ///< weights of the rows in a metric for singular M (MassMetric)

  /// b = |Phi_q| |M^-1 |Q|| + |gamma|, with absolute values of every component: the size of the right side
  /// Phi_q M^-1 Q - gamma of S lambda if the terms do not cancel. At least cancellation_floor times
  /// schur_rhs_bound_uncancelled, if that is known.
  VectorX<double> schur_rhs_bound;
  /// b with every term of Q, gamma and Phi by magnitude (magnitude_bounds.hpp); empty if not known.
  VectorX<double> schur_rhs_bound_uncancelled;
  VectorX<double> acceleration_scale;  ///< square root of the metric's diagonal [6 nb]
  /// |L^-1 Q| + |E^-1 gamma| in the metric L L^T: the size of the accelerations that Q and gamma cause. At
  /// least cancellation_floor times the same from the magnitudes of their terms.
  double acceleration_bound = 0;
};

/// Least ratio of b to schur_rhs_bound_uncancelled. Smaller b are raised to it. If all terms of b cancel, the
/// remainder is rounding error and must not be the scale of lambda. 1e-8 is half of the digits of a double.
inline constexpr double cancellation_floor = 1e-8;

/// The norms at a state. W = L^-1 Phi^T [6 nb x nc] with the metric L L^T. E are its column norms.
RowNorms row_norms(const TangentSystem& system, const MassMetric& metric, const MatrixX<double>& W);

/// 1 / v for every component, and 0 where v is 0, as for a row without a gradient.
VectorX<double> inverse_or_zero(const VectorX<double>& v);

}  // namespace trivium
