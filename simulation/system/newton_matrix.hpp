#pragma once
/// Newton's matrix of a step, factored along the graph of bodies, joints and springs:
///
///     [ M + gamma' C + beta' K   Phi_q^T ]
///     [ Phi_q                    0       ]
///
/// gamma' = dv/dv' and beta' = dq/dv' within the step (integrators::Shares); their primes are part of the
/// names. spring_rows.hpp contributes the stiffness K and the damping C of springs. The dependent rows are
/// those that the acceleration solver found at the last accepted state; this file does not detect any.

#include <memory>
#include <stdexcept>
#include <vector>

#include "formulations/structured/acceleration_solver.hpp"
#include "simulation/system/evaluation.hpp"

namespace trivium {

/// Factors of Newton's matrix, with the evaluation that they were made from. `at` throws a std::logic_error
/// if nothing has been factored.
template <Formulation F>
class NewtonFactors {
 public:
  using S = typename F::Scalar;

  /// The evaluation that the factors were made from.
  const EvaluatedModel<F>& at() const {
    if (!model_) throw std::logic_error("factors are used before they have been computed");
    return *model_;
  }
  void solve(const GraphVector<S>& right_side, GraphVector<S>& solution) const {
    solver_->solve(right_side, solution);
  }
  /// Factors the assembled matrix of an evaluation, with the dependent rows of `accelerations`. Throws a
  /// ModelError that names a singular body.
  void factor(const Evaluation<F>& of, AccelerationSolver<F>& accelerations) {
    if (!solver_ || model_->plan != of->plan) solver_ = std::make_unique<GraphSolver<S>>(*of->plan);
    model_ = of.shared();
    model_->is_factored = true;
    solver_->keep_dependent_rows_of(accelerations.factors());
    try {
      solver_->factor(model_->assembly.matrix());
    } catch (const SingularLink& link) {
      throw accelerations.named(link, model_->t);
    }
  }

 private:
  std::unique_ptr<GraphSolver<S>> solver_;
  std::shared_ptr<EvaluatedModel<F>> model_;
};

/// Assembles, factors and solves Newton's system. It also converts between the vectors of the graph and the
/// flat vectors of the methods. In a flat vector, rows are in the order of the mechanism, forces and motions
/// in the order of v.
template <Formulation F>
class NewtonMatrix {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;
  using Layout = StateLayout<F>;

  /// The mechanism must outlive this object.
  NewtonMatrix(const MechanismOf<F>&&, const EliminationPlan&) = delete;
  NewtonMatrix(const MechanismOf<F>&, const EliminationPlan&&) = delete;
  NewtonMatrix(const MechanismOf<F>& mechanism, const EliminationPlan& plan)
      : mechanism_(mechanism), place_(mechanism.nc()), change_(plan.graph) {
    const auto& edges = plan.graph.edges;
    for (int e = 0; e < static_cast<int>(edges.size()); ++e)
      if (!edges[e].is_soft)
        for (int k = 0; k < edges[e].size(); ++k) place_[edges[e].rows[k]] = {e, k};
  }

  /// Assembles M and the rows at the current body states.
  void assemble(GraphAssembly<F>& assembly, const S& t) {
    for (const auto& link : assembly.links()) assembly.assemble_link(link, t, change_);
    assembly.assemble_closings(t, change_);
  }
  /// Throws as NewtonFactors::factor does.
  void factor(const Evaluation<F>& at, AccelerationSolver<F>& accelerations, NewtonFactors<F>& factors) {
    ++factorisations_;
    factors.factor(at, accelerations);
  }
  long factorisations() const { return factorisations_; }

  /// Adds the solution to x, a vector like v in the coordinates of `body`, and to mu, one number per row.
  void solve(const NewtonFactors<F>& factors, const std::vector<typename F::Reduced>& body,
             const GraphVector<S>& right_side, StateVector& x, StateVector& mu) {
    factors.solve(right_side, change_);
    for (int b = 0; b < mechanism_.nb(); ++b)
      Layout::of(x, b) += (typename Layout::Velocity() << unpadded<S>(change_.body[b].r),
                           F::increment(body[b], unpadded<S>(change_.body[b].x)))
                              .finished();
    for (std::size_t row = 0; row < place_.size(); ++row) mu[row] += at_row(change_, row);
  }
  /// The solution of the last `solve`, in the graph's own form.
  const GraphVector<S>& solution() const { return change_; }

  void put_rows(const StateVector& rows, GraphVector<S>& right_side) const {
    for (std::size_t row = 0; row < place_.size(); ++row)
      right_side.edge[place_[row].edge][place_[row].k] = rows[row];
  }
  void take_rows(const GraphVector<S>& right_side, StateVector& rows) const {
    rows.resize(mechanism_.nc());
    for (std::size_t row = 0; row < place_.size(); ++row) rows[row] = at_row(right_side, row);
  }
  /// Puts reduced forces into a right side: the first six numbers of every body in `left`.
  void put_reduced(const StateVector& left, GraphVector<S>& right_side) const {
    for (int b = 0; b < mechanism_.nb(); ++b) {
      right_side.body[b].r.template head<3>() = left.template segment<3>(Layout::velocities * b);
      right_side.body[b].x.template head<3>() = left.template segment<3>(Layout::velocities * b + 3);
    }
  }
  /// Reduces a generalised force, given in the coordinates of the bodies `body`.
  void reduce(const std::vector<typename F::Reduced>& body, const StateVector& force,
              StateVector& left) const {
    left.resize(Layout::velocities * mechanism_.nb());
    if constexpr (Layout::velocities > 6) left.setZero();
    for (int b = 0; b < mechanism_.nb(); ++b)
      Layout::of(left, b).template head<6>() << Layout::r_of(force, b),
          F::reduced(body[b], Layout::q_of(force, b));
  }

 private:
  const S& at_row(const GraphVector<S>& values, std::size_t row) const {
    return values.edge[place_[row].edge][place_[row].k];
  }

  const MechanismOf<F>& mechanism_;
  std::vector<EdgeRow> place_;  ///< per row: its edge of the graph and its number there
  GraphVector<S> change_;
  long factorisations_ = 0;
};

}  // namespace trivium
