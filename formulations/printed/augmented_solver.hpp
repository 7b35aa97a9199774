#pragma once
/// The augmented system of one formulation, solved as printed, dense: accelerations and lambda at one state.
/// Dependent rows are left out of the matrix; of the multipliers that then are equivalent those of minimum
/// norm are reported.

#include <vector>

#include "bodies/numbers/scalar.hpp"
#include "formulations/analysis/row_analysis.hpp"
#include "formulations/printed/dense_solver.hpp"
#include "formulations/printed/redundant_multipliers.hpp"
#include "formulations/printed/residual.hpp"
#include "formulations/solution.hpp"
#include "mechanism/model.hpp"

namespace trivium {

/// One formulation's augmented system at one state, and what a solution of it means. The system is solved
/// with its dependent rows left out: x is a solution of that reduced system, in printed order.
template <EquationsAsPrinted F>
class AugmentedEquations {
 public:
  using S = typename F::Scalar;

  /// Mechanism and rows must outlive this.
  AugmentedEquations(const MechanismOf<F>& mechanism, const MechanismState<S>& state, const RowAnalysis& rows,
                     const ChartOptions& options = {});
  AugmentedEquations(const MechanismOf<F>&&, const MechanismState<S>&, const RowAnalysis&,
                     const ChartOptions& = {}) = delete;
  AugmentedEquations(const MechanismOf<F>&, const MechanismState<S>&, const RowAnalysis&&,
                     const ChartOptions& = {}) = delete;

  const EquationsOfMotion<F>& equations() const { return eom_; }
  const std::vector<BodyState<F>>& states() const { return states_; }
  const RowAnalysis& rows() const { return rows_; }

  MatrixX<S> reduced_matrix() const;
  VectorX<S> reduced_right_side() const;

  /// All unknowns, lambda 0 in dependent rows.
  VectorX<S> expand(const VectorX<S>& x) const;
  VectorX<S> reduce(const VectorX<S>& full) const;
  /// b - K x over all equations and unknowns, dependent rows among them.
  VectorX<S> defect(const VectorX<S>& full) const;
  /// The unknowns by name.
  Unknowns<F> split(const VectorX<S>& full) const;
  PhysicalSolution<S> accelerations_of(const VectorX<S>& full) const;
  /// The residual of every body's own equations and of every row.
  MatrixFreeResidual residual(const VectorX<S>& full) const;

 private:
  const MechanismOf<F>& mechanism_;
  const RowAnalysis& rows_;
  std::vector<BodyState<F>> states_;
  EquationsOfMotion<F> eom_;
  std::vector<Eigen::Index> kept_;
  MatrixX<S> K_;  ///< as printed, all rows
  VectorX<S> b_;
};

/// The same with its reduced matrix factored.
template <EquationsAsPrinted F>
class AugmentedSolver : public AugmentedEquations<F> {
 public:
  using S = typename F::Scalar;

  AugmentedSolver(const MechanismOf<F>& mechanism, const MechanismState<S>& state, const RowAnalysis& rows,
                  const ChartOptions& options = {});
  AugmentedSolver(const MechanismOf<F>&&, const MechanismState<S>&, const RowAnalysis&,
                  const ChartOptions& = {}) = delete;
  AugmentedSolver(const MechanismOf<F>&, const MechanismState<S>&, const RowAnalysis&&,
                  const ChartOptions& = {}) = delete;

  /// All unknowns in printed order, lambda of minimum norm among the equivalent.
  VectorX<S> solve() const;
  /// Dependent rows left out; throws a ModelError where the matrix is numerically singular.
  VectorX<S> solve_reduced() const;
  /// The reduced K^-1 b by the factors at hand, unrefined.
  VectorX<S> substitute(const VectorX<S>& b) const;

  VectorX<S> to_minimum_norm(VectorX<S> full) const;
  const RedundantMultipliers<S>& redundant_multipliers() const { return redundant_multipliers_; }

 private:
  DenseSolver<S> solver_;
  RedundantMultipliers<S> redundant_multipliers_;
};

/// Accelerations and lambda of a model in one formulation, solved as printed.
template <EquationsAsPrinted F>
PhysicalSolution<typename F::Scalar> solve_printed(const ModelOf<F>& model, const RowAnalysis& rows,
                                                   const ChartOptions& charts = {});

}  // namespace trivium
