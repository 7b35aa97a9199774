#pragma once
/// GraphSolver: one step of iterative refinement, in one pass along the plan. The residual of each link is
/// formed just before it is passed to the parent. A part of graph_solver_impl.hpp.

#include <algorithm>
#include <type_traits>

#include "formulations/structured/elimination_impl.hpp"

namespace trivium {

template <class S>
void GraphSolver<S>::correct(const GraphMatrix<S>& matrix, const GraphVector<S>& right_side,
                             const GraphVector<S>& solution, GraphVector<S>& residual,
                             GraphVector<S>& correction) {
  std::fill(residual.body.begin(), residual.body.end(), BodyPart<S>{});
  for (std::size_t c = 0; c < closing_.size(); ++c) {
    const int edge = plan_.closings[c].edge;
    edge_residual(matrix, edge, right_side, solution, residual);
    closing_[c].gamma = residual.edge[edge];
  }
  for (const EliminationPlan::Step& step : plan_.steps) {
    for (int c : step.closings) forward_closing(c, &residual.body[plan_.closings[c].body]);
    if (step.link < 0) continue;
    link_residual(matrix, step.link, right_side, solution, residual);
    const EliminationPlan::Link& link = plan_.links[step.link];
    pass_up(step.link, residual.body[link.body], residual,
            has_parent(link) ? &residual.body[link.parent] : nullptr);
  }
  finish(residual, correction);
}

template <class S>
inline void GraphSolver<S>::link_residual(const GraphMatrix<S>& matrix, int index,
                                          const GraphVector<S>& right_side, const GraphVector<S>& solution,
                                          GraphVector<S>& residual) {
  const EliminationPlan::Link& link = plan_.links[index];
  const BodyPart<S>& child = solution.body[link.body];
  const BodyBlock<S>& H = matrix.H[link.body];
  BodyPart<S> left = right_side.body[link.body];
  left.r -= times<S, 3>(H.rr, child.r) + times<S, 3>(H.rx, child.x);
  left.x -= padded_transpose_times<S>(H.rx, child.r) + times<S, 3>(H.xx, child.x);
  residual.body[link.body] += left;
  if (link.edge < 0) return;
  with_link(place_[index], [&](auto& factors) {
    if constexpr (std::is_same_v<std::decay_t<decltype(factors)>, GeneralLink<S>>) {
      edge_residual(matrix, link.edge, right_side, solution, residual);
    } else {
      residual.edge[link.edge] = right_side.edge[link.edge];
      factors.take_residual(rows_of(index), child, has_parent(link) ? &solution.body[link.parent] : nullptr,
                            solution.edge[link.edge], residual.body[link.body],
                            has_parent(link) ? &residual.body[link.parent] : nullptr,
                            residual.edge[link.edge]);
    }
  });
}

template <class S>
void GraphSolver<S>::edge_residual(const GraphMatrix<S>& matrix, int e, const GraphVector<S>& right_side,
                                   const GraphVector<S>& solution, GraphVector<S>& residual) const {
  const GraphEdge& edge = plan_.graph.edges[e];
  const EdgeRows<S>& rows = matrix.rows[plan_.rows_slot[e]];
  residual.edge[e] = right_side.edge[e] + rows.compliance * solution.edge[e];
  const auto one = [&](int body, const BodyColumns<S>& C) {
    if (body == plan_.graph.bodies) return;
    for (int k = 0; k < edge.size(); ++k) {
      residual.body[body].r -= solution.edge[e][k] * C.r.col(k);
      residual.body[body].x -= solution.edge[e][k] * C.x.col(k);
      residual.edge[e][k] -= C.r.col(k).dot(solution.body[body].r) + C.x.col(k).dot(solution.body[body].x);
    }
  };
  one(edge.i, rows.C_i);
  one(edge.j, rows.C_j);
}

}  // namespace trivium
