#pragma once
/// Newton's matrix of a step in factors,
///
///   [ M + gamma' C + beta' K   Phi_q^T ]
///   [ Phi_q                    0       ]
///
/// along the graph of bodies, joints and springs. The stiffness K and the damping C of springs are put there
/// by spring_rows.hpp. Which rows are dependent is not decided here: those of the acceleration solver at the
/// last accepted state are.

#include <memory>
#include <stdexcept>
#include <vector>

#include "formulations/structured/acceleration_solver.hpp"
#include "simulation/system/evaluation.hpp"

namespace trivium {

template <Formulation F>
class NewtonFactors {
 public:
  using S = typename F::Scalar;

  /// What they are of.
  const EvaluatedModel<F>& at() const {
    if (!model_) throw std::logic_error("factors are used before they have been computed");
    return *model_;
  }
  void solve(const GraphVector<S>& right_side, GraphVector<S>& solution) const {
    solver_->solve(right_side, solution);
  }
  /// Throws a ModelError.
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

/// Assembles, factors and solves, and carries numbers between the graph and the flat vectors that methods
/// see: rows by number, and forces and motions in the places of v.
template <Formulation F>
class NewtonMatrix {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;
  using Layout = StateLayout<F>;

  /// The mechanism must outlive this.
  NewtonMatrix(const MechanismOf<F>&&, const EliminationPlan&) = delete;
  NewtonMatrix(const MechanismOf<F>&, const EliminationPlan&&) = delete;
  NewtonMatrix(const MechanismOf<F>& mechanism, const EliminationPlan& plan)
      : mechanism_(mechanism), place_(mechanism.nc()), change_(plan.graph) {
    const auto& edges = plan.graph.edges;
    for (int e = 0; e < static_cast<int>(edges.size()); ++e)
      if (!edges[e].is_soft)
        for (int k = 0; k < edges[e].size(); ++k) place_[edges[e].rows[k]] = {e, k};
  }

  /// M and the rows, where the bodies are.
  void assemble(GraphAssembly<F>& assembly, const S& t) {
    for (const auto& link : assembly.links()) assembly.assemble_link(link, t, change_);
    assembly.assemble_closings(t, change_);
  }
  /// Throws a ModelError.
  void factor(const Evaluation<F>& at, AccelerationSolver<F>& accelerations, NewtonFactors<F>& factors) {
    ++factorisations_;
    factors.factor(at, accelerations);
  }
  long factorisations() const { return factorisations_; }

  /// Adds the solution to x, which is of v's kind at these bodies, and to mu.
  void solve(const NewtonFactors<F>& factors, const std::vector<typename F::Reduced>& body,
             const GraphVector<S>& right_side, StateVector& x, StateVector& mu) {
    factors.solve(right_side, change_);
    for (int b = 0; b < mechanism_.nb(); ++b)
      Layout::of(x, b) += (typename Layout::Velocity() << unpadded<S>(change_.body[b].r),
                           F::increment(body[b], unpadded<S>(change_.body[b].x)))
                              .finished();
    for (std::size_t row = 0; row < place_.size(); ++row) mu[row] += at_row(change_, row);
  }
  /// Of the last solve.
  const GraphVector<S>& solution() const { return change_; }

  void put_rows(const StateVector& rows, GraphVector<S>& right_side) const {
    for (std::size_t row = 0; row < place_.size(); ++row)
      right_side.edge[place_[row].edge][place_[row].k] = rows[row];
  }
  void take_rows(const GraphVector<S>& right_side, StateVector& rows) const {
    rows.resize(mechanism_.nc());
    for (std::size_t row = 0; row < place_.size(); ++row) rows[row] = at_row(right_side, row);
  }
  /// Reduced forces: the first six places of a body.
  void put_reduced(const StateVector& left, GraphVector<S>& right_side) const {
    for (int b = 0; b < mechanism_.nb(); ++b) {
      right_side.body[b].r.template head<3>() = left.template segment<3>(Layout::velocities * b);
      right_side.body[b].x.template head<3>() = left.template segment<3>(Layout::velocities * b + 3);
    }
  }
  /// A generalised force on these bodies, reduced.
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
  std::vector<EdgeRow> place_;  ///< by row
  GraphVector<S> change_;
  long factorisations_ = 0;
};

}  // namespace trivium
