#pragma once
/// The definitions of augmented_solver.hpp, compiled in instances/ for float to Real50, and in Real100 the
/// equations alone. Include this file for a Scalar without an instance, and for your own formulations,
/// constraints or effects.

#include <fmt/format.h>

#include "base/error.hpp"
#include "formulations/printed/augmented_solver.hpp"

namespace trivium {

template <EquationsAsPrinted F>
AugmentedEquations<F>::AugmentedEquations(const MechanismOf<F>& mechanism, const MechanismState<S>& state,
                                          const RowAnalysis& rows, const ChartOptions& options)
    : mechanism_(mechanism),
      rows_(rows),
      states_(to_coordinates<F>(mechanism, state, options)),
      eom_(equations_of_motion<F>(mechanism, states_, state.t)) {
  const AugmentedSystem<F> system = augmented_system(eom_);
  K_ = system.matrix();
  b_ = system.right_side();
  const Eigen::Index fixed = K_.rows() - system.nc;
  for (Eigen::Index k = 0; k < fixed; ++k) kept_.push_back(k);
  for (int k : rows.independent) kept_.push_back(fixed + k);
}

template <EquationsAsPrinted F>
auto AugmentedEquations<F>::reduced_matrix() const -> MatrixX<S> {
  return rows_.dependent.empty() ? K_ : MatrixX<S>(K_(kept_, kept_));
}
template <EquationsAsPrinted F>
auto AugmentedEquations<F>::reduced_right_side() const -> VectorX<S> {
  return b_(kept_);
}

template <EquationsAsPrinted F>
auto AugmentedEquations<F>::expand(const VectorX<S>& x) const -> VectorX<S> {
  VectorX<S> full = VectorX<S>::Zero(K_.rows());
  full(kept_) = x;
  return full;
}
template <EquationsAsPrinted F>
auto AugmentedEquations<F>::reduce(const VectorX<S>& full) const -> VectorX<S> {
  return full(kept_);
}
template <EquationsAsPrinted F>
auto AugmentedEquations<F>::defect(const VectorX<S>& full) const -> VectorX<S> {
  return b_ - K_ * full;
}

template <EquationsAsPrinted F>
Unknowns<F> AugmentedEquations<F>::split(const VectorX<S>& full) const {
  return split_unknowns<F>(full, eom_.nb(), eom_.nc());
}
template <EquationsAsPrinted F>
auto AugmentedEquations<F>::accelerations_of(const VectorX<S>& full) const -> PhysicalSolution<S> {
  const Unknowns<F> u = split(full);
  PhysicalSolution<S> out;
  for (int b = 0; b < eom_.nb(); ++b) {
    out.r_ddot.push_back(u.body[b].r_ddot);
    out.omega_bar_dot.push_back(F::to_angular_acceleration(eom_.body[b], u.body[b].q_ddot));
  }
  out.lambda = u.lambda;
  return out;
}
template <EquationsAsPrinted F>
MatrixFreeResidual AugmentedEquations<F>::residual(const VectorX<S>& full) const {
  return matrix_free_residual<F>(mechanism_, eom_, split(full), rows_.dependent);
}

namespace detail {
/// The multipliers that are not unique, in r-omega; none if all rows are independent.
template <class S, class Types>
RedundantMultipliers<S> redundant_multipliers(const Mechanism<S, Types>& mechanism,
                                              const MechanismState<S>& state, const RowAnalysis& rows) {
  if (rows.null_basis.cols() == 0) return {};
  using F = ROmega<S>;
  return {equations_of_motion<F>(mechanism, to_coordinates<F>(mechanism, state, {}), state.t), rows};
}
}  // namespace detail

template <EquationsAsPrinted F>
AugmentedSolver<F>::AugmentedSolver(const MechanismOf<F>& mechanism, const MechanismState<S>& state,
                                    const RowAnalysis& rows, const ChartOptions& options)
    : AugmentedEquations<F>(mechanism, state, rows, options),
      solver_(this->reduced_matrix()),
      redundant_multipliers_(detail::redundant_multipliers(mechanism, state, rows)) {}

template <EquationsAsPrinted F>
auto AugmentedSolver<F>::solve() const -> VectorX<S> {
  return to_minimum_norm(this->expand(solve_reduced()));
}
template <EquationsAsPrinted F>
auto AugmentedSolver<F>::solve_reduced() const -> VectorX<S> {
  VectorX<S> x = solver_.solve(this->reduced_right_side());
  if (x.allFinite()) return x;
  const NarrowRow* weakest = nullptr;
  for (const NarrowRow& row : this->rows().narrow)  // by falling shares
    if (row.counts()) weakest = &row;
  if (!weakest)
    throw ModelError("the augmented matrix is numerically singular at this state; a wider --scalar may help");
  throw ModelError(
      {fmt::format("row \"{}\"", this->mechanism().row_names[weakest->row])},
      "this row nearly depends on others, and the augmented matrix is numerically singular at this state; "
      "take a wider --scalar, or solve with the structured solver");
}
template <EquationsAsPrinted F>
auto AugmentedSolver<F>::substitute(const VectorX<S>& b) const -> VectorX<S> {
  return solver_.substitute(b);
}
template <EquationsAsPrinted F>
auto AugmentedSolver<F>::to_minimum_norm(VectorX<S> full) const -> VectorX<S> {
  VectorX<S> lambda = full.tail(this->equations().nc());
  redundant_multipliers_.to_minimum_norm(lambda);
  full.tail(lambda.size()) = lambda;
  return full;
}

template <EquationsAsPrinted F>
PhysicalSolution<typename F::Scalar> solve_printed(const ModelOf<F>& model, const RowAnalysis& rows,
                                                   const ChartOptions& charts) {
  const AugmentedSolver<F> solver(model.mechanism, model.state, rows, charts);
  return solver.accelerations_of(solver.solve());
}

}  // namespace trivium
