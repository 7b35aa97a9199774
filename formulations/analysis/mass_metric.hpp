#pragma once
/// The metric in which accelerations and row gradients are measured: the mass matrix M, or M plus weighted
/// rows if M is singular. This file defines the weights of the rows and finds motions that have neither
/// inertia nor a constraint.

#include <vector>

#include "formulations/analysis/tangent_system.hpp"

namespace trivium {

/// A symmetric positive definite metric of the tangent space: M, or M + Phi^T diag(mu) Phi if M is singular.
/// The term mu_k Phi_k^T Phi_k is about as large as the inertia of the lighter of the two bodies of row k:
/// mu_k is the smallest of m / |Phi_r|^2 and tr(J_bar) / |Phi_pi_bar|^2 over both bodies, without the terms
/// whose gradient or tr(J_bar) is 0. If no term remains, because the row acts only on rotations of bodies
/// with J_bar = 0, m times 1 m^2 stands for tr(J_bar). The unit of mu_k is kg divided by the square of the
/// unit of Phi_r. mu_k is rounded to a power of two, so that products with mu_k are exact. Except for this
/// rounding and for the stand-in of 1 m^2, the metric does not depend on units or on the scale of a row.
/// Unique multipliers and accelerations do not depend on mu.
class MassMetric {
 public:
  /// Throws a ModelError that names a body and an axis if [M; Phi] does not have full column rank.
  explicit MassMetric(const TangentSystem& system);

  /// Weights mu, one per row; all zero if M is regular.
  const VectorX<double>& mu() const { return mu_; }
  /// The diagonal of the metric [6 nb: kg, kg m^2], in the order of the columns of TangentSystem::Phi.
  const VectorX<double>& diagonal() const { return diagonal_; }
  /// L^-1 x for x [6 nb x any], where the metric is L L^T.
  MatrixX<double> half_solve(const MatrixX<double>& x) const;
  /// L^-T x.
  MatrixX<double> half_solve_transposed(const MatrixX<double>& x) const;

 private:
  void factor_blocks(const TangentSystem& system);
  void factor_augmented(const TangentSystem& system);

  VectorX<double> mu_, diagonal_;
  std::vector<Matrix3<double>> block_factor_;  ///< Cholesky factor of J_bar per body; used if M is regular
  VectorX<double> root_mass_;
  MatrixX<double> axes_, dense_factor_;  ///< if M is singular: principal axes, Cholesky factor in them
};

}  // namespace trivium
