#pragma once
/// Newton's matrix of a step in factors,
///
///   [ M + gamma' C + beta' K   Phi_q^T ]
///   [ Phi_q                    0       ]
///
/// along the graph of bodies, joints and springs. The stiffness K and the damping C of springs are put there
/// by spring_rows.hpp, which ConstrainedEquations::factor asks first. Several can be kept side by side, as
/// those of the stages of one step. Which rows are dependent is not decided here: those of the
/// acceleration solver at the last accepted state are.

#include <array>
#include <deque>

#include "formulations/structured/acceleration_solver.hpp"
#include "simulation/system/state_layout.hpp"

namespace trivium {

template <Formulation F>
class NewtonMatrix {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;
  using Layout = StateLayout<F>;

  /// Both must outlive this.
  NewtonMatrix(const Mechanism<S>& mechanism, const EliminationPlan& plan)
      : mechanism_(mechanism), plan_(plan), change_(plan.graph) {
    select(0);
  }

  /// All that follows is about the matrix of this number, until the next is selected.
  void select(int number) {
    while (static_cast<int>(kept_.size()) <= number) kept_.emplace_back(mechanism_, plan_);
    selected_ = &kept_[number];
  }
  /// What is evaluated from now on leaves the factors at hand as they are.
  void begin_evaluation() { selected_->in_use = 1 - selected_->in_factors; }
  GraphAssembly<F>& evaluated() { return selected_->evaluated(); }
  const GraphAssembly<F>& factored() const { return selected_->factored(); }
  /// M and the rows, where the bodies of `evaluated` are.
  void assemble(const S& t) {
    GraphAssembly<F>& assembly = evaluated();
    for (const auto& link : assembly.links()) assembly.assemble_link(link, t, change_);
    assembly.assemble_closings(t, change_);
  }
  /// Factors what was evaluated last. Throws a ModelError.
  void factor(AccelerationSolver<F>& accelerations, const S& t) {
    selected_->solver.keep_dependent_rows_of(accelerations.factors());
    ++factorisations_;
    try {
      selected_->solver.factor(evaluated().matrix());
    } catch (const SingularLink& link) {
      throw accelerations.named(link, t);
    }
    selected_->in_factors = selected_->in_use;
  }
  long factorisations() const { return factorisations_; }
  /// Solves by the factors at hand: adds to x, and to lambda where there is one.
  void solve(const GraphVector<S>& right_side, StateVector& x, StateVector* lambda) {
    selected_->solver.solve(right_side, change_);
    for (int b = 0; b < mechanism_.nb(); ++b)
      Layout::of(x, b) += (typename Layout::Velocity() << unpadded<S>(change_.body[b].r),
                           F::increment(evaluated().body()[b], unpadded<S>(change_.body[b].x)))
                              .finished();
    if (lambda != nullptr)
      for_each_row([&](std::size_t e, int k, int row) { (*lambda)[row] += change_.edge[e][k]; });
  }
  // between flat vectors, of rows by number and of forces in the places of velocities, and the graph's
  void put_rows(const StateVector& rows, GraphVector<S>& right_side) const {
    for_each_row([&](std::size_t e, int k, int row) { right_side.edge[e][k] = rows[row]; });
  }
  void take_rows(const GraphVector<S>& right_side, StateVector& rows) const {
    rows.resize(mechanism_.nc());
    for_each_row([&](std::size_t e, int k, int row) { rows[row] = right_side.edge[e][k]; });
  }
  /// Reduced forces: the first six places of a body.
  void put_reduced(const StateVector& left, GraphVector<S>& right_side) const {
    for (int b = 0; b < mechanism_.nb(); ++b)
      right_side.body[b] = BodyPart<S>::of(left.template segment<6>(Layout::velocities * b));
  }
  void take_reduced(const GraphVector<S>& right_side, StateVector& left) const {
    left.setZero(Layout::velocities * mechanism_.nb());
    for (int b = 0; b < mechanism_.nb(); ++b)
      Layout::of(left, b).template head<6>() = right_side.body[b].six();
  }
  /// A generalised force, reduced where the matrix in factors is.
  void put_force(const StateVector& force, GraphVector<S>& right_side) const {
    for (int b = 0; b < mechanism_.nb(); ++b)
      right_side.body[b] = {padded<S>(Layout::r_of(force, b)),
                            padded<S>(F::reduced(factored().body()[b], Layout::q_of(force, b)))};
  }
  void reduce(const StateVector& force, StateVector& left) const {
    left.setZero(Layout::velocities * mechanism_.nb());
    for (int b = 0; b < mechanism_.nb(); ++b)
      Layout::of(left, b).template head<6>() << Layout::r_of(force, b),
          F::reduced(factored().body()[b], Layout::q_of(force, b));
  }

  /// The solution of the last solve.
  const GraphVector<S>& solution() const { return change_; }

 private:
  /// Calls visit(edge, k, row) for the mechanism's rows.
  template <class Visit>
  void for_each_row(const Visit& visit) const {
    const auto& edges = plan_.graph.edges;
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (!edges[e].is_soft)
        for (int k = 0; k < edges[e].size(); ++k) visit(e, k, edges[e].rows[k]);
  }
  /// Beside the matrix in factors, what was evaluated last: the factors go on using their own rows.
  struct Kept {
    GraphSolver<S> solver;
    std::array<GraphAssembly<F>, 2> at;
    int in_use = 0, in_factors = 1;

    Kept(const Mechanism<S>& mechanism, const EliminationPlan& plan)
        : solver(plan), at{GraphAssembly<F>(mechanism, plan), GraphAssembly<F>(mechanism, plan)} {}
    GraphAssembly<F>& evaluated() { return at[in_use]; }
    const GraphAssembly<F>& factored() const { return at[in_factors]; }
  };

  const Mechanism<S>& mechanism_;
  const EliminationPlan& plan_;
  std::deque<Kept> kept_;
  Kept* selected_ = nullptr;
  GraphVector<S> change_;
  long factorisations_ = 0;
};

}  // namespace trivium
