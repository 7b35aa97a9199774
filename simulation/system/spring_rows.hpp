#pragma once
/// The stiffness and damping of springs in Newton's matrix. Each spring or damper that resists is a row of
/// its own, along its own direction, beside the rows of the constraints. It gives way by its compliance
///
///   1 / (gamma' c + beta' k),
///
/// where v moves with v' by gamma' and q by beta'; eliminated, it adds gamma' C + beta' K to M. A stiff
/// spring then costs the condition of the matrix no more than a constraint does.

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

/// The mechanism's graph, with a soft edge for each of them.
template <class S, class Types>
BodyJointGraph graph_with_springs(const Mechanism<S, Types>& mechanism) {
  BodyJointGraph graph = body_joint_graph(mechanism);
  for_each_resisting_spring(mechanism.effects, [&](const auto& spring) {
    const auto [i, j] = spring.bodies();
    graph.edges.push_back({{i, j}, {-1}, false, true, true});
  });
  return graph;
}

template <Formulation F>
class SpringRows {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;
  /// Of a body: the size of the numbers whose differences springs pull and turn it by.
  struct SpringSize {
    S force{0}, moment{0};
  };
  /// By body, the ground last; empty where there are no springs.
  using Sizes = std::vector<SpringSize>;

  /// The plan is that of graph_with_springs. Both must outlive this.
  SpringRows(const MechanismOf<F>&&, const EliminationPlan&) = delete;
  SpringRows(const MechanismOf<F>&, const EliminationPlan&&) = delete;
  SpringRows(const MechanismOf<F>& mechanism, const EliminationPlan& plan)
      : mechanism_(mechanism), plan_(plan) {
    const auto& edges = plan_.graph.edges;
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (edges[e].is_soft) soft_.push_back(static_cast<int>(e));
  }

  int count() const { return static_cast<int>(soft_.size()); }
  /// [N/m, N s/m], or of moments by angles [N m, N m s].
  void constants(StateVector& stiffness, StateVector& damping) const {
    stiffness.resize(soft_.size());
    damping.resize(soft_.size());
    int s = 0;
    for_each_resisting_spring(mechanism_.effects, [&](const auto& spring) {
      stiffness[s] = spring.stiffness;
      damping[s++] = spring.damping;
    });
  }
  /// What springs and dampers do along themselves.
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
  /// Stiffness and damping into Newton's matrix, where q and v move with v' by these shares.
  void let_resist(GraphAssembly<F>& assembly, const S& velocity_share, const S& position_share) const {
    auto edge = soft_.begin();
    for_each_resisting_spring(mechanism_.effects, [&](const auto& spring) {
      EdgeRows<S>& rows = assembly.edge_rows(plan_.rows_slot[*edge++]);
      const S resistance = velocity_share * spring.damping + position_share * spring.stiffness;
      if (resistance == S(0)) rows = {};  // an explicit method's
      rows.compliance = resistance == S(0) ? S(1) : S(1 / resistance);
    });
  }

  /// Springs resist all that a solution stretches them by.
  void clear_slack(GraphVector<S>& right_side) const {
    for (const int e : soft_) right_side.edge[e].setZero();
  }
  /// Springs resist only what a solution stretches them by beyond their slack.
  void put_slack(const StateVector& slack, GraphVector<S>& right_side) const {
    for (std::size_t s = 0; s < soft_.size(); ++s) right_side.edge[soft_[s]][0] = slack[s];
  }
  /// By how much the solution stretches them.
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
  std::vector<int> soft_;  ///< edges of springs, in the effects' order
};

}  // namespace trivium
