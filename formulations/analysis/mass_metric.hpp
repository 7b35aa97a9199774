#pragma once
/// The metric of the tangent space in which accelerations and rows are measured: the mass matrix, or the mass
/// matrix with weighted rows added where it is singular. Decided here: the weights of those rows, and which
/// motions have no inertia and no constraint.

#include <vector>

#include "formulations/analysis/tangent_system.hpp"

namespace trivium {

/// A symmetric positive definite metric of the tangent space: M, or where M is singular
/// M + Phi^T diag(mu) Phi. mu_k makes row k as heavy as the lighter of its bodies: the least of
/// m / |Phi_r|^2 and tr(Jbar) / |Phi_pi_bar|^2 over them, to the nearest power of two, so that the metric
/// depends neither on units nor on how a row is scaled (but for that rounding). Multipliers and accelerations
/// do not change with mu.
class MassMetric {
 public:
  /// Throws a ModelError that names the body and axis where [M; Phi] lacks full column rank.
  explicit MassMetric(const TangentSystem& system);

  /// One per row; all zero where M is regular.
  const VectorX<double>& mu() const { return mu_; }
  const VectorX<double>& diagonal() const { return diagonal_; }
  /// L^-1 x, where the metric is L L^T.
  MatrixX<double> half_solve(const MatrixX<double>& x) const;
  /// L^-T x.
  MatrixX<double> half_solve_transposed(const MatrixX<double>& x) const;

 private:
  void factor_blocks(const TangentSystem& system);
  void factor_augmented(const TangentSystem& system);

  VectorX<double> mu_, diagonal_;
  std::vector<Matrix3<double>> block_factor_;  ///< of Jbar, per body; used where M is regular
  VectorX<double> root_mass_;
  MatrixX<double> axes_, dense_factor_;  ///< where M is singular: principal axes, and the factor in them
};

}  // namespace trivium
