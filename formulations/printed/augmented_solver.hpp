#pragma once
/// The dense solver of the printed equations: accelerations and lambda of one formulation at one state. The
/// matrix omits the dependent rows. If several lambda exert the same forces, the one of minimum |E lambda| is
/// returned.

#include <vector>

#include "bodies/numbers/scalar.hpp"
#include "formulations/analysis/row_analysis.hpp"
#include "formulations/printed/dense_solver.hpp"
#include "formulations/printed/redundant_multipliers.hpp"
#include "formulations/printed/residual.hpp"
#include "formulations/solution.hpp"
#include "mechanism/model.hpp"

namespace trivium {

/// The augmented system K x = b of one formulation at one state. A full vector holds all unknowns in printed
/// order (augmented_system.hpp). A reduced vector omits the multipliers of dependent rows.
template <EquationsAsPrinted F>
class AugmentedEquations {
 public:
  using S = typename F::Scalar;

  /// `mechanism` and `rows` must outlive this object.
  AugmentedEquations(const MechanismOf<F>& mechanism, const MechanismState<S>& state, const RowAnalysis& rows,
                     const ChartOptions& options = {});
  AugmentedEquations(const MechanismOf<F>&&, const MechanismState<S>&, const RowAnalysis&,
                     const ChartOptions& = {}) = delete;
  AugmentedEquations(const MechanismOf<F>&, const MechanismState<S>&, const RowAnalysis&&,
                     const ChartOptions& = {}) = delete;

  const EquationsOfMotion<F>& equations() const { return eom_; }
  const std::vector<BodyState<F>>& states() const { return states_; }
  const RowAnalysis& rows() const { return rows_; }
  const MechanismOf<F>& mechanism() const { return mechanism_; }

  MatrixX<S> reduced_matrix() const;
  VectorX<S> reduced_right_side() const;

  /// The full vector of a reduced one, with lambda = 0 in dependent rows.
  VectorX<S> expand(const VectorX<S>& x) const;
  VectorX<S> reduce(const VectorX<S>& full) const;
  /// b - K x over all equations and unknowns, dependent rows included.
  VectorX<S> defect(const VectorX<S>& full) const;
  /// The parts of a full vector by name.
  Unknowns<F> split(const VectorX<S>& full) const;
  PhysicalSolution<S> accelerations_of(const VectorX<S>& full) const;
  /// The relative residual of the equations of every body and of every row.
  MatrixFreeResidual residual(const VectorX<S>& full) const;

 private:
  const MechanismOf<F>& mechanism_;
  const RowAnalysis& rows_;
  std::vector<BodyState<F>> states_;
  EquationsOfMotion<F> eom_;
  std::vector<Eigen::Index> kept_;
  MatrixX<S> K_;  ///< as printed, with all rows
  VectorX<S> b_;
};

/// The augmented system with the factors of its reduced matrix.
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

  /// The full solution, with lambda of minimum |E lambda| among equivalent multipliers.
  VectorX<S> solve() const;
  /// The reduced solution. Throws a ModelError if the matrix is numerically singular.
  VectorX<S> solve_reduced() const;
  /// The reduced K^-1 b from the factors, without iterative refinement.
  VectorX<S> substitute(const VectorX<S>& b) const;

  /// Replaces lambda by the equivalent multipliers of minimum |E lambda|.
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
