#pragma once
/// Multipliers that are not unique, in the precision of the solve. Decided here: which combinations of them
/// act on nothing (the null space of Phi^T, begun in double by row_analysis.hpp), and the choice among
/// equivalent ones, that of least |E lambda|.

#include <vector>

#include "bodies/numbers/scalar.hpp"
#include "formulations/analysis/row_analysis.hpp"
#include "formulations/printed/dense_solver.hpp"

namespace trivium {

/// The null space of Phi^T in Scalar, over the rows that the analysis found dependent.
///
/// Which rows are dependent is decided in double (row_analysis.hpp); the combinations themselves are refined
/// until Phi^T N no longer shrinks. Coordinates that are rounded in the scene leave rows that only nearly
/// depend on each other; N is then the least-squares combination, and what Phi^T N keeps is the scene's own
/// ambiguity.
template <class Scalar>
class RedundantMultipliers {
 public:
  using Equations = EquationsOfMotion<ROmega<Scalar>>;

  /// All are unique.
  RedundantMultipliers() = default;
  RedundantMultipliers(const Equations& eom, const RowAnalysis& rows);

  bool none() const { return gram_.empty(); }

  /// Makes lambda the one of minimum |E lambda| among those with the same Phi^T lambda. Unique components do
  /// not change.
  void to_minimum_norm(VectorX<Scalar>& lambda) const;

  /// What the right side of the rows would have to change by, least in E^-1, for rows that miss by `residual`
  /// to agree: the residual's share along the null space.
  VectorX<Scalar> disagreement(const VectorX<Scalar>& residual) const;

 private:
  /// f(body, columns of that body, the row's gradient there) for every body of row k.
  template <class Visit>
  static void for_each_body(const Equations& eom, int k, const Visit& visit);

  void refine_null_basis(const Equations& eom, const RowAnalysis& rows);

  /// E_k^2 = Phi_k (metric)^-1 Phi_k^T of the rows in N.
  void weigh(const Equations& eom, const RowAnalysis& rows);

  /// M + Phi^T diag(mu) Phi.
  static MatrixX<Scalar> dense_metric(const Equations& eom, const VectorX<double>& mu);

  MatrixX<Scalar> N_;
  VectorX<Scalar> E2_;
  std::vector<DenseSolver<Scalar>> gram_;  ///< N^T E^2 N; empty where all rows are independent
};

}  // namespace trivium
