#pragma once
/// GraphSolver: the pass along the elimination plan, link by link from the leaves to the roots, and the back
/// substitution in the opposite order. A part of graph_solver_impl.hpp.

#include <algorithm>
#include <cmath>

#include "bodies/numbers/scalar.hpp"
#include "formulations/structured/graph_solver.hpp"

namespace trivium {

template <class S>
GraphSolver<S>::GraphSolver(EliminationPlan plan)
    : dependent_pivot_(trivium::dependent_pivot<S>()),
      near_singular_pivot_(trivium::near_singular_pivot<S>()),
      plan_(std::move(plan)),
      block_sum_(plan_.sum_slots),
      column_(plan_.column_slots),
      coupling_(plan_.coupling_slots),
      closing_(plan_.closings.size()),
      force_sum_(plan_.sum_slots) {
  is_dependent_.resize(plan_.graph.edges.size());
  is_marked_ = is_dependent_;
  int columns = 0;
  std::array<int, 5> count{};
  for (const EliminationPlan::Link& link : plan_.links) {
    const int kind = plan_.is_point_link(link) ? plan_.graph.edges[link.edge].size() - 3 : general;
    place_.push_back(
        {kind, count[kind]++, columns, link.edge >= 0 ? plan_.graph.edges[link.edge].size() : 0});
    columns += static_cast<int>(link.columns.size());
  }
  link_column_.resize(columns);
  for (std::size_t c = 0; c < closing_.size(); ++c)
    closing_[c].rows = plan_.graph.edges[plan_.closings[c].edge].size();
  std::get<0>(links_).resize(count[0]);
  std::get<1>(links_).resize(count[1]);
  std::get<2>(links_).resize(count[2]);
  std::get<3>(links_).resize(count[3]);
  std::get<4>(links_).resize(count[4]);
}

template <class S>
GraphSolver<S>::~GraphSolver() = default;

template <class S>
template <class Visit>
void GraphSolver<S>::with_link(const Place& place, const Visit& visit) {
  switch (place.kind) {
    case 0:
      return visit(std::get<0>(links_)[place.index]);
    case 1:
      return visit(std::get<1>(links_)[place.index]);
    case 2:
      return visit(std::get<2>(links_)[place.index]);
    case 3:
      return visit(std::get<3>(links_)[place.index]);
    default:
      return visit(std::get<4>(links_)[place.index]);
  }
}

template <class S>
[[gnu::always_inline]] inline LinkRows<S> GraphSolver<S>::rows_of(int index) const {
  const EliminationPlan::Link& link = plan_.links[index];
  if (place_[index].kind != general || link.edge < 0)
    return {matrix_->point[index], no_columns_, no_columns_, 0};
  const EdgeRows<S>& edge = matrix_->rows[plan_.rows_slot[link.edge]];
  return {matrix_->point[index], link.body_is_j ? edge.C_j : edge.C_i, link.body_is_j ? edge.C_i : edge.C_j,
          place_[index].rows};
}

template <class S>
void GraphSolver<S>::factor(const GraphMatrix<S>& matrix) {
  factor_once(matrix);
  const auto joint_is_dependent = [&](const EliminationPlan::Link& link) {
    return link.edge >= 0 && !plan_.is_point_link(link) && has_dependent_rows(link.edge);
  };
  if (how_ == DependentRows::keep) restore_kept_rows();
  if (how_ != DependentRows::detect) return;
  if (has_nearly_dependent_rows_ || std::any_of(plan_.links.begin(), plan_.links.end(), joint_is_dependent))
    restore_independent_rows();
}

template <class S>
void GraphSolver<S>::factor_once(const GraphMatrix<S>& matrix) {
  start_factors(matrix);
  for (const EliminationPlan::Step& step : plan_.steps) factor_step(step);
}

template <class S>
void GraphSolver<S>::solve(const GraphVector<S>& right_side, GraphVector<S>& solution) {
  start_solution(right_side);
  for (const EliminationPlan::Step& step : plan_.steps) forward_step(step, right_side);
  finish(right_side, solution);
}

template <class S>
void GraphSolver<S>::start(const GraphMatrix<S>& matrix, const GraphVector<S>& right_side) {
  start_factors(matrix);
  start_solution(right_side);
}

template <class S>
void GraphSolver<S>::eliminate(int step, const GraphVector<S>& right_side) {
  factor_step(plan_.steps[step]);
  forward_step(plan_.steps[step], right_side);
}

template <class S>
void GraphSolver<S>::substitute(GraphVector<S>& solution) {
  for (auto step = plan_.steps.rbegin(); step != plan_.steps.rend(); ++step) {
    if (step->link >= 0) backward_link(step->link, solution);
    for (auto c = step->closings.rbegin(); c != step->closings.rend(); ++c) backward_closing(*c, solution);
  }
  solution.body.back() = {};
}

template <class S>
void GraphSolver<S>::finish(const GraphVector<S>& right_side, GraphVector<S>& solution) {
  for (int n = 0; n < bordered_; ++n)
    borders_[n].gamma = right_side.edge[borders_[n].row.edge][borders_[n].row.k];
  substitute(solution);
  for (int n = 0; n < bordered_; ++n) {
    const Border& border = borders_[n];
    const GraphEdge& edge = plan_.graph.edges[border.row.edge];
    const auto [on_i, on_j] = on_bodies(border.row);
    const BodyPart<S>&a_i = solution.body[edge.i], &a_j = solution.body[edge.j];
    const S missing =
        border.gamma - on_i.r.dot(a_i.r) - on_i.x.dot(a_i.x) - on_j.r.dot(a_j.r) - on_j.x.dot(a_j.x);
    solution.add(missing / border.mobility, border.response);
  }
}

template <class S>
void GraphSolver<S>::start_factors(const GraphMatrix<S>& matrix) {
  matrix_ = &matrix;
  bordered_ = 0;
  has_nearly_dependent_rows_ = false;
  weakest_pivot_ = S(1);
  for (const EliminationPlan::Link& link : plan_.links)
    for (const EliminationPlan::Column& column : link.columns) column_[column.slot] = {};
  for (Matrix6<S>& block : coupling_) block.setZero();
  for (std::size_t c = 0; c < closing_.size(); ++c) {
    const EliminationPlan::Closing& closing = plan_.closings[c];
    if (closing.column_slot >= 0) column_[closing.column_slot] = {};
    if (closing.slot_i >= 0) column_[closing.slot_i] = matrix_->rows[plan_.rows_slot[closing.edge]].C_i;
    if (closing.slot_j >= 0) column_[closing.slot_j] = matrix_->rows[plan_.rows_slot[closing.edge]].C_j;
    closing_[c].size.setZero();
    const S compliance = matrix_->rows[plan_.rows_slot[closing.edge]].compliance;
    closing_[c].own.setConstant(compliance);
    coupling_[plan_.diagonal_slot[c]].diagonal().setConstant(compliance);
  }
}

template <class S>
void GraphSolver<S>::start_solution(const GraphVector<S>& right_side) {
  for (std::size_t c = 0; c < closing_.size(); ++c)
    closing_[c].gamma = right_side.edge[plan_.closings[c].edge];
}

template <class S>
inline void GraphSolver<S>::factor_step(const EliminationPlan::Step& step) {
  for (int c : step.closings)
    factor_closing(c, step.link < 0 ? nullptr : &block_sum_[plan_.links[step.link].sum_slot]);
  if (step.link >= 0) factor_link(step.link);
}

template <class S>
inline void GraphSolver<S>::forward_step(const EliminationPlan::Step& step,
                                         const GraphVector<S>& right_side) {
  for (int c : step.closings)
    forward_closing(c, step.link < 0 ? nullptr : &force_sum_[plan_.links[step.link].sum_slot]);
  if (step.link >= 0) forward_link(step.link, right_side);
}

template <class S>
inline void GraphSolver<S>::factor_link(int index) {
  const EliminationPlan::Link& link = plan_.links[index];
  const LinkRows<S> rows = rows_of(index);
  with_link(place_[index], [&](auto& factors) {
    std::array<bool, 6> dependent{};
    if (how_ != DependentRows::detect && link.edge >= 0) dependent = is_marked_[link.edge];
    BodyBlock<S>* const parent = has_parent(link) ? &block_sum_[link.parent_sum_slot] : nullptr;
    if (link.is_first) *parent = matrix_->H[link.parent];
    const Elimination result = factors.factor(
        link.sum_slot < 0 ? matrix_->H[link.body] : block_sum_[link.sum_slot], rows, parent, how_, dependent);
    if (result != Elimination::done) throw_singular(link, result);
    if (link.edge >= 0) is_dependent_[link.edge] = dependent;
    if constexpr (std::is_same_v<std::decay_t<decltype(factors)>, GeneralLink<S>>)
      has_nearly_dependent_rows_ = has_nearly_dependent_rows_ || factors.has_nearly_dependent_rows();
    LinkColumn<S>* const columns = link_column_.data() + place_[index].first_column;
    for (std::size_t n = 0; n < link.columns.size(); ++n) {
      const EliminationPlan::Column& column = link.columns[n];
      factors.factor(column_[column.slot], rows_of_closing(column.closing), rows, columns[n],
                     closing_[column.closing].size,
                     column.parent_slot >= 0 ? &column_[column.parent_slot] : nullptr);
    }
    for (const EliminationPlan::Coupling& pair : link.couplings) {
      const int a = link.columns[pair.first].closing, b = link.columns[pair.second].closing;
      Matrix6<S>& sum = coupling_[pair.slot];
      if (a == b) closing_[a].own -= sum.diagonal();
      factors.couple(columns[pair.first], columns[pair.second], rows_of_closing(b), sum);
      if (a == b) closing_[a].own += sum.diagonal();
    }
  });
}

template <class S>
inline void GraphSolver<S>::forward_link(int index, const GraphVector<S>& right_side) {
  const EliminationPlan::Link& link = plan_.links[index];
  BodyPart<S>* const parent = has_parent(link) ? &force_sum_[link.parent_sum_slot] : nullptr;
  if (link.is_first) *parent = right_side.body[link.parent];
  pass_up(index, link.sum_slot < 0 ? right_side.body[link.body] : force_sum_[link.sum_slot], right_side,
          parent);
}

template <class S>
inline void GraphSolver<S>::pass_up(int index, const BodyPart<S>& force, const GraphVector<S>& right_side,
                                    BodyPart<S>* parent) {
  const EliminationPlan::Link& link = plan_.links[index];
  with_link(place_[index], [&](auto& factors) {
    factors.forward(force, link.edge >= 0 ? right_side.edge[link.edge] : none_, rows_of(index), parent);
    const LinkColumn<S>* column = link_column_.data() + place_[index].first_column;
    for (const EliminationPlan::Column& c : link.columns) {
      for (int k = 0; k < rows_of_closing(c.closing); ++k)
        closing_[c.closing].gamma[k] -= factors.closing_rate(*column, k);
      ++column;
    }
  });
}

template <class S>
inline void GraphSolver<S>::backward_link(int index, GraphVector<S>& solution) {
  const EliminationPlan::Link& link = plan_.links[index];
  with_link(place_[index], [&](auto& factors) {
    const LinkColumn<S>* column = link_column_.data() + place_[index].first_column;
    for (const EliminationPlan::Column& c : link.columns) {
      const Vector6<S>& lambda = solution.edge[plan_.closings[c.closing].edge];
      for (int k = 0; k < rows_of_closing(c.closing); ++k) factors.add_multiplier(*column, k, lambda[k]);
      ++column;
    }
    factors.backward(has_parent(link) ? &solution.body[link.parent] : nullptr, rows_of(index),
                     solution.body[link.body], link.edge >= 0 ? solution.edge[link.edge] : nowhere_);
  });
}

template <class S>
[[noreturn]] void GraphSolver<S>::throw_singular(const EliminationPlan::Link& link, Elimination result) {
  throw SingularLink(link.body,
                     result == Elimination::no_inertia
                         ? "the joint to its parent leaves a motion free in which the body has no inertia"
                         : "the orientation rows of the joint to its parent depend on each other");
}

}  // namespace trivium
