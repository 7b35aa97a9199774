#pragma once
/// GraphSolver: finds the candidates that are independent and borders them to the factors. A part of
/// graph_solver_impl.hpp.
///
/// A pivot is the square of the sine between a row and the rows before it, so its rounding error hides sines
/// below sqrt(u). The row's remainder, the part outside the span of the other rows, is not squared and can be
/// computed. Let a be the motion that a force along row k causes if the right sides of the other rows are 0,
/// and H the block diagonal matrix of the bodies' blocks (graph_system.hpp). Then H a is the remainder:
/// Phi_k^T minus the best combination of the other rows. The system is solved for a, and a^T H a is the pivot
/// without the loss of digits.
///
/// Whether the remainder is large enough is a question of geometry, not of inertia. It is answered by a
/// second factorisation, with unit inertias (unit_inertia_solver_impl.hpp). The tolerances are in
/// analysis/rank_tolerance.hpp.

#include <algorithm>
#include <memory>
#include <utility>

#include "formulations/structured/graph_solver.hpp"
#include "formulations/structured/unit_inertia_solver_impl.hpp"

namespace trivium {

template <class S>
bool GraphSolver<S>::restore_independent_rows() {
  candidates_.clear();
  for (int e = 0; e < static_cast<int>(is_dependent_.size()); ++e)
    for (int k = 0; k < plan_.graph.edges[e].size(); ++k)
      if (is_dependent_[e][k]) candidates_.push_back({e, k});
  if (candidates_.empty()) return false;
  measure_levers();
  const int before = bordered_;
  for (const EdgeRow& row : unit_inertia_solver_->independent(candidates_)) border(row);
  return bordered_ > before;
}

template <class S>
void GraphSolver<S>::measure_levers() {
  if (!unit_inertia_solver_) unit_inertia_solver_ = std::make_shared<UnitInertiaSolver>(plan_);
  unit_inertia_solver_->factor(*matrix_);
}

template <class S>
int GraphSolver<S>::weak_rows_by_geometry() {
  measure_levers();
  return unit_inertia_solver_->weak_rows();
}

template <class S>
S GraphSolver<S>::lever2(int body) const {
  return unit_inertia_solver_->lever2(body);
}

template <class S>
bool GraphSolver<S>::border(const EdgeRow& row) {
  Probe& probe = cleared_probe();
  add_row(row, S(1), probe.load);
  solve(probe.load, probe.response);
  refine(probe);
  const S mobility = energy(probe.response);
  // a response that is rounding error changes by about its own size in another step of refinement
  correct(*matrix_, probe.load, probe.response, probe.rest, probe.rest);
  if (!(mobility > S(least_energy_above_rounding) * energy(probe.rest))) return false;
  if (bordered_ == most_restored) throw NearlyDependentRows(row);
  if (bordered_ == static_cast<int>(borders_.size()))
    borders_.push_back({row, S(0), GraphVector<S>(plan_.graph), S(0)});
  Border& border = borders_[bordered_++];
  border.row = row;
  border.mobility = mobility;
  std::swap(border.response, probe.response);
  border.response.edge[row.edge][row.k] = S(-1);
  is_dependent_[row.edge][row.k] = false;
  return true;
}

template <class S>
typename GraphSolver<S>::Probe& GraphSolver<S>::cleared_probe() {
  if (!probe_)
    probe_ = Probe{GraphVector<S>(plan_.graph), GraphVector<S>(plan_.graph), GraphVector<S>(plan_.graph)};
  std::fill(probe_->load.body.begin(), probe_->load.body.end(), BodyPart<S>{});
  return *probe_;
}

template <class S>
void GraphSolver<S>::refine(Probe& probe) {
  correct(*matrix_, probe.load, probe.response, probe.rest, probe.rest);
  probe.response.add(S(1), probe.rest);
}

template <class S>
std::array<BodyPart<S>, 2> GraphSolver<S>::on_bodies(const EdgeRow& row) const {
  const GraphEdge& edge = plan_.graph.edges[row.edge];
  const EdgeRows<S>& columns = matrix_->rows[plan_.rows_slot[row.edge]];
  const auto on = [&](int body, const BodyColumns<S>& C) {
    return body == plan_.graph.bodies ? BodyPart<S>{} : BodyPart<S>{C.r.col(row.k), C.x.col(row.k)};
  };
  return {on(edge.i, columns.C_i), on(edge.j, columns.C_j)};
}

template <class S>
void GraphSolver<S>::add_row(const EdgeRow& row, const S& multiplier, GraphVector<S>& force) const {
  const GraphEdge& edge = plan_.graph.edges[row.edge];
  const auto [on_i, on_j] = on_bodies(row);
  force.body[edge.i] += BodyPart<S>{multiplier * on_i.r, multiplier * on_i.x};
  force.body[edge.j] += BodyPart<S>{multiplier * on_j.r, multiplier * on_j.x};
}

template <class S>
S GraphSolver<S>::energy(const GraphVector<S>& a) const {
  S sum(0);
  for (int b = 0; b < plan_.graph.bodies; ++b) {
    const BodyBlock<S>& H = matrix_->H[b];
    const BodyPart<S>& part = a.body[b];
    sum += part.r.dot(times<S, 3>(H.rr, part.r) + S(2) * times<S, 3>(H.rx, part.x)) +
           part.x.dot(times<S, 3>(H.xx, part.x));
  }
  return sum;
}

}  // namespace trivium
