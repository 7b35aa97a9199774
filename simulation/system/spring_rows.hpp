#pragma once
/// The stiffness k and damping c of springs in Newton's matrix. Every spring or damper with k or c different
/// from 0 is an extra row in addition to the rows of the constraints. With the gradient g of its length or
/// angle, and its force f as the multiplier, the row is
///
///     g x - f / (gamma' c + beta' k) = slack,   gamma' = dv/dv',  beta' = dq/dv'  in the step
///
/// x is the solution of Newton's system, a change of v', and g x the stretch that it causes. slack is the
/// part of the stretch that meets no resistance, as a rule 0. The primes of gamma' and beta' are part of
/// these names (integrators::Shares). The compliance of the row is 1 / (gamma' c + beta' k). Elimination of f
/// adds the spring's part of gamma' C + beta' K to M. As a row, a stiff spring worsens the condition number
/// no more than a constraint does.

#include <algorithm>
#include <utility>
#include <vector>

#include "formulations/structured/graph_assembly.hpp"
#include "simulation/system/state_layout.hpp"

namespace trivium {

/// Calls visit(effect) for every spring or damper that resists.
template <class Effects, class Visit>
void for_each_resisting_spring(const Effects& effects, const Visit& visit) {
  effects.for_each_spring([&](const auto& spring) {
    if (spring.stiffness != 0 || spring.damping != 0) visit(spring);
  });
}

/// The mechanism's graph, with one soft edge for every spring or damper that resists.
template <class S, class Types>
BodyJointGraph graph_with_springs(const Mechanism<S, Types>& mechanism) {
  BodyJointGraph graph = body_joint_graph(mechanism);
  for_each_resisting_spring(mechanism.effects, [&](const auto& spring) {
    const auto [i, j] = spring.bodies();
    graph.edges.push_back({{i, j}, {-1}, false, true, true});
  });
  return graph;
}

/// The rows of all springs and dampers that resist: their gradients, compliances and slacks.
template <Formulation F>
class SpringRows {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;
  /// Per body: the size of the numbers whose difference is the force [N] or moment [N m] of its springs. The
  /// machine epsilon times this size is the rounding of that force or moment.
  struct SpringSize {
    S force{0}, moment{0};
  };
  /// Per body, the ground last; empty if there are no springs.
  using Sizes = std::vector<SpringSize>;

  /// The plan is that of graph_with_springs. Mechanism and plan must outlive this object.
  SpringRows(const MechanismOf<F>&&, const EliminationPlan&) = delete;
  SpringRows(const MechanismOf<F>&, const EliminationPlan&&) = delete;
  SpringRows(const MechanismOf<F>& mechanism, const EliminationPlan& plan)
      : mechanism_(mechanism), plan_(plan) {
    const auto& edges = plan_.graph.edges;
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (edges[e].is_soft) soft_.push_back(static_cast<int>(e));
  }

  int count() const { return static_cast<int>(soft_.size()); }
  /// Stiffness and damping per spring [N/m, N s/m]; of torsional springs [N m/rad, N m s/rad].
  void constants(StateVector& stiffness, StateVector& damping) const {
    stiffness.resize(soft_.size());
    damping.resize(soft_.size());
    int s = 0;
    for_each_resisting_spring(mechanism_.effects, [&](const auto& spring) {
      stiffness[s] = spring.stiffness;
      damping[s++] = spring.damping;
    });
  }
  /// Sets the gradients of the spring rows at the current body states, and the sizes of the spring forces.
  void evaluate(GraphAssembly<F>& assembly, const EffectView<S>& view, Sizes& sizes) const {
    if (soft_.empty()) return;
    sizes.assign(mechanism_.nb() + 1, SpringSize{});
    auto edge = soft_.begin();
    for_each_resisting_spring(mechanism_.effects, [&](const auto& spring) {
      EdgeRows<S>& rows = assembly.edge_rows(plan_.rows_slot[*edge++]);
      const auto gradient = spring.gradient(view);
      const auto put = [&](BodyColumns<S>& column, int b, const Wrench<S>& on) {
        const typename F::Reduced& body = assembly.body()[b];
        column.r.col(0) = padded<S>(on.F);
        column.x.col(0) = padded<S>(F::reduced(body, F::applied_force(body, on.n_bar)));
      };
      const auto [i, j] = spring.bodies();
      put(rows.C_i, i, gradient.first);
      put(rows.C_j, j, gradient.second);
      const S size = spring.tension_scale(view);
      for (const auto& [b, on] : {std::pair(i, &gradient.first), std::pair(j, &gradient.second)}) {
        sizes[b].force += size * on->F.norm();
        sizes[b].moment += size * on->n_bar.norm();
      }
    });
  }
  /// Sets the compliances of the spring rows for the shares gamma' = dv/dv' and beta' = dq/dv' of the step.
  void let_resist(GraphAssembly<F>& assembly, const S& velocity_share, const S& position_share) const {
    auto edge = soft_.begin();
    for_each_resisting_spring(mechanism_.effects, [&](const auto& spring) {
      EdgeRows<S>& rows = assembly.edge_rows(plan_.rows_slot[*edge++]);
      const S resistance = velocity_share * spring.damping + position_share * spring.stiffness;
      // shares of 0 ask for M and Phi_q alone, as half-explicit methods and RATTLE do: the row has no effect
      if (resistance == S(0)) rows = {};
      rows.compliance = resistance == S(0) ? S(1) : S(1 / resistance);
    });
  }

  /// Sets the slack of all springs to 0: a spring resists the whole stretch g x by the solution.
  void clear_slack(GraphVector<S>& right_side) const {
    for (const int e : soft_) right_side.edge[e].setZero();
  }
  /// Sets the slack of every spring: the spring resists only g x - slack.
  void put_slack(const StateVector& slack, GraphVector<S>& right_side) const {
    for (std::size_t s = 0; s < soft_.size(); ++s) right_side.edge[soft_[s]][0] = slack[s];
  }
  /// The stretch g x of every spring, which equals slack + compliance . f.
  void stretch_of(const GraphAssembly<F>& factored, const StateVector& slack, const GraphVector<S>& solution,
                  StateVector& stretch) const {
    stretch.resize(slack.size());
    for (std::size_t s = 0; s < soft_.size(); ++s) {
      const int slot = plan_.rows_slot[soft_[s]];
      stretch[s] = slack[s] + factored.matrix().rows[slot].compliance * solution.edge[soft_[s]][0];
    }
  }

 private:
  const MechanismOf<F>& mechanism_;
  const EliminationPlan& plan_;
  std::vector<int> soft_;  ///< the edges of the springs, in the order of the effects
};

}  // namespace trivium
