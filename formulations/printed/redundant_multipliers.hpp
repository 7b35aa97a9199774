#pragma once
/// Multipliers that are not unique, in the precision of the solution. row_analysis.hpp computes the null
/// space of Phi^T in double. Here it is refined, and among all lambda that exert the same forces the one of
/// minimum |E lambda| is chosen.

#include <vector>

#include "bodies/numbers/scalar.hpp"
#include "formulations/analysis/row_analysis.hpp"
#include "formulations/printed/dense_solver.hpp"

namespace trivium {

/// The null space N of Phi^T in Scalar, over the rows whose multipliers are not unique.
///
/// Which rows are dependent is decided in double (row_analysis.hpp). N itself is refined in Scalar as long as
/// Phi^T N shrinks. If rounded coordinates in the scene make rows only nearly dependent, N is the
/// least-squares combination, and the rest of Phi^T N is an ambiguity of the scene data.
template <class Scalar>
class RedundantMultipliers {
 public:
  using Equations = EquationsOfMotion<ROmega<Scalar>>;

  /// For mechanisms in which all rows with a gradient are independent.
  RedundantMultipliers() = default;
  RedundantMultipliers(const Equations& eom, const RowAnalysis& rows);

  bool none() const { return gram_.empty(); }

  /// Replaces lambda by the multipliers of minimum |E lambda| with the same Phi^T lambda. Unique components
  /// do not change.
  void to_minimum_norm(VectorX<Scalar>& lambda) const;

  /// `residual` are the residuals of the rows at some accelerations. Returns their part along the null space,
  /// which no accelerations can remove. The right sides of the rows less this part are consistent, and it is
  /// the smallest such change in the norm of E^-1.
  VectorX<Scalar> disagreement(const VectorX<Scalar>& residual) const;

 private:
  /// Calls visit(body, gradient [1x6]) for each body of row k except the ground.
  template <class Visit>
  static void for_each_body(const Equations& eom, int k, const Visit& visit);

  void refine_null_basis(const Equations& eom, const RowAnalysis& rows);

  /// Computes E_k^2 = Phi_k (metric)^-1 Phi_k^T of the rows whose multipliers are not unique.
  void weigh(const Equations& eom, const RowAnalysis& rows);

  /// M + Phi^T diag(mu) Phi [6 nb x 6 nb].
  static MatrixX<Scalar> dense_metric(const Equations& eom, const VectorX<double>& mu);

  MatrixX<Scalar> N_;
  VectorX<Scalar> E2_;
  std::vector<DenseSolver<Scalar>> gram_;  ///< factors of N^T E^2 N; empty if all rows are independent
};

}  // namespace trivium
