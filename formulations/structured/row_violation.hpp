#pragma once
/// Finds a dependent row that a solution violates. Dependent rows have the multiplier 0, so the solution
/// satisfies them only if their right sides agree with the other rows. Tolerances: rank_tolerance.hpp.

#include <optional>
#include <span>

#include "formulations/structured/graph_solver.hpp"

namespace trivium {

/// The largest magnitude among the components of an acceleration, by part.
template <class S>
struct AccelerationSize {
  S r{0}, x{0};

  static AccelerationSize of(const BodyPart<S>& part) {
    using std::abs;
    AccelerationSize size;
    for (int k = 0; k < 3; ++k) size.take({S(abs(part.r[k])), S(abs(part.x[k]))});
    return size;
  }
  void take(const AccelerationSize& other) {
    r = larger(r, other.r);
    x = larger(x, other.x);
  }
};

/// The first dependent row of the given edges, none of them a point joint of the tree, with
///
///     |gamma - Phi a| > tolerance (|gamma| + |Phi| size) + least
///
/// where size_of_body(b) is the AccelerationSize of body b. In a batch, a violation in any lane counts.
template <class S, class SizeOfBody>
std::optional<EdgeRow> find_violated_row(const GraphSolver<S>& solver, std::span<const int> edges,
                                         const GraphMatrix<S>& matrix, const GraphVector<S>& right_side,
                                         const GraphVector<S>& solution, const S& tolerance, const S& least,
                                         const SizeOfBody& size_of_body) {
  using std::abs;
  const EliminationPlan& plan = solver.plan();
  for (const int e : edges) {
    if (!solver.has_dependent_rows(e)) continue;
    const GraphEdge& edge = plan.graph.edges[e];
    const EdgeRows<S>& rows = matrix.rows[plan.rows_slot[e]];
    const auto size_of = [&](int b) {
      return b == plan.graph.bodies ? AccelerationSize<S>{} : size_of_body(b);
    };
    const AccelerationSize<S> size_i = size_of(edge.i), size_j = size_of(edge.j);
    for (int k = 0; k < edge.size(); ++k) {
      if (!solver.is_dependent(e, k)) continue;
      S missing = right_side.edge[e][k], made_of = abs(missing);
      const auto take = [&](const BodyColumns<S>& C, int b, const AccelerationSize<S>& size) {
        if (b == plan.graph.bodies) return;
        const BodyPart<S>& a = solution.body[b];
        missing -= C.r.col(k).dot(a.r) + C.x.col(k).dot(a.x);
        made_of += C.r.col(k).cwiseAbs().sum() * size.r + C.x.col(k).cwiseAbs().sum() * size.x;
      };
      take(rows.C_i, edge.i, size_i);
      take(rows.C_j, edge.j, size_j);
      if (!all(abs(missing) <= tolerance * made_of + least)) return EdgeRow{e, k};
    }
  }
  return {};
}

}  // namespace trivium
