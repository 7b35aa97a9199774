#pragma once
/// GraphSolver: the elimination of a closing at the body where the links of its loop meet. Before this step
/// the equations of the closing c are, with the body's unknowns a, the closing's columns C on this body and
/// the coupling blocks B,
///
///     C^T a - B_cc lambda_c - sum over later closings of B_cn lambda_n = gamma_c
///
/// The pivots of B_cc = L D L^T decide which rows of the closing are dependent (tolerances:
/// rank_tolerance.hpp). A closing that is eliminated at the ground has no a and no C. Its multipliers then
/// couple with those of later closings only. A part of graph_solver_impl.hpp.

#include <algorithm>

#include "bodies/numbers/scalar.hpp"
#include "formulations/structured/graph_solver.hpp"

namespace trivium {

template <class S>
void GraphSolver<S>::factor_closing(int c, BodyBlock<S>* body) {
  const EliminationPlan::Closing& closing = plan_.closings[c];
  ClosingFactor& f = closing_[c];
  Matrix6<S>& block = coupling_[plan_.diagonal_slot[c]];
  const int n = rows_of_closing(c);
  std::array<bool, 6>& dependent = is_dependent_[closing.edge];
  const bool on_body = closing.column_slot >= 0;
  if (on_body) f.C = column_[closing.column_slot];
  if (how_ == DependentRows::detect_near_singular || how_ == DependentRows::keep_count) choose_rows(c);
  // A pivot is the diagonal entry of a row after the rows and closings before it were eliminated. own: the
  // entry before other closings were eliminated. size.product: the size of the entry if no terms had
  // cancelled on the way along the loop. The rounding error of the pivot is relative to the sum of both. If
  // the pivot is below sine2 * size.product, the row has cancelled nearly to direction_tolerance of its
  // terms, and the remainder has no reliable direction. is_marked_: rows that are dependent whatever their
  // pivot is, by an earlier decision, by the caller or by choose_rows().
  const S sine = S(cancelled_candidate) * direction_tolerance<S>(plan_.graph.rank_tolerance),
          sine2 = sine * sine;
  for (int k = 0; k < n; ++k) {
    const S pivot = block(k, k);
    const S cancelled = sine2 * f.size.product[k];
    const S rounding = pivot_rounding<S>() * (f.own[k] + f.size.product[k]);
    switch (how_) {
      case DependentRows::detect:
        dependent[k] = pivot <= dependent_pivot_ * f.own[k] + cancelled;
        break;
      case DependentRows::detect_near_singular:
      case DependentRows::keep:
      case DependentRows::keep_count:
        dependent[k] = is_marked_[closing.edge][k] || pivot <= rounding;
    }
    has_nearly_dependent_rows_ = has_nearly_dependent_rows_ || (dependent[k] && any(pivot > rounding));
    f.inverse[k] = dependent[k] ? S(0) : S(1 / pivot);
    for (int r = k + 1; r < n; ++r) {
      const S l = block(k, r) * f.inverse[k];
      f.L(r, k) = l;
      if (dependent[k]) continue;
      for (int s = r; s < n; ++s) block(r, s) -= l * block(k, s);
      if (on_body) {
        f.C.r.col(r) -= l * f.C.r.col(k);
        f.C.x.col(r) -= l * f.C.x.col(k);
      }
      for (const EliminationPlan::Neighbour& next : closing.later)
        coupling_[next.slot].row(r) -= l * coupling_[next.slot].row(k);
    }
  }
  for (int k = 0; k < n; ++k) {
    if (dependent[k]) continue;
    if (on_body) {
      const Padded<S> r = f.C.r.col(k), x = f.C.x.col(k);
      const Padded<S> scaled_r = f.inverse[k] * r, scaled_x = f.inverse[k] * x;
      for (int m = 0; m < 3; ++m) {
        body->rr.col(m) += r * scaled_r[m];
        body->rx.col(m) += r * scaled_x[m];
        body->xx.col(m) += x * scaled_x[m];
      }
      for (const EliminationPlan::Neighbour& next : closing.later)
        if (next.column_slot >= 0)
          for (int m = 0; m < rows_of_closing(next.closing); ++m) {
            column_[next.column_slot].r.col(m) -= coupling_[next.slot](k, m) * scaled_r;
            column_[next.column_slot].x.col(m) -= coupling_[next.slot](k, m) * scaled_x;
          }
    }
    for (const EliminationPlan::Fill& fill : closing.fill) {
      const EliminationPlan::Neighbour &a = closing.later[fill.first], &b = closing.later[fill.second];
      const Vector6<S> of_a = f.inverse[k] * coupling_[a.slot].row(k).transpose();
      for (int s = 0; s < rows_of_closing(b.closing); ++s)
        coupling_[fill.slot].col(s) -= of_a * coupling_[b.slot](k, s);
    }
  }
}

template <class S>
void GraphSolver<S>::choose_rows(int c) {
  // keep_count chooses as many rows as were independent before, but not necessarily the same ones.
  // detect_near_singular excludes rows that are marked already, and rows whose relative pivot is at most
  // near_singular_pivot_. The pivots of the rows not yet chosen change with every choice, because the chosen
  // row is eliminated from them.
  const ClosingFactor& f = closing_[c];
  Matrix6<S> block = coupling_[plan_.diagonal_slot[c]];
  const int n = rows_of_closing(c);
  std::array<bool, 6>& out = is_marked_[plan_.closings[c].edge];
  std::array<bool, 6> is_done{};
  int most = n;
  S least = S(0);
  if (how_ == DependentRows::keep_count) {
    most -= static_cast<int>(std::count(out.begin(), out.begin() + n, true));
  } else {
    is_done = out;
    least = near_singular_pivot_;
  }
  for (int chosen = 0; chosen < most; ++chosen) {
    int best = -1;
    S best_share = least;
    for (int k = 0; k < n; ++k) {
      const S share = block(k, k) / (f.own[k] + f.size.product[k]);
      if (is_done[k] || !(share > best_share)) continue;
      best = k;
      best_share = share;
    }
    if (best < 0) break;
    is_done[best] = true;
    if (best_share < weakest_pivot_) weakest_pivot_ = best_share;
    const Vector6<S> column = block.col(best);
    block -= column * column.transpose() / column[best];
  }
  for (int k = 0; k < n; ++k) out[k] = !is_done[k] || (how_ == DependentRows::detect_near_singular && out[k]);
}

template <class S>
void GraphSolver<S>::forward_closing(int c, BodyPart<S>* body) {
  const EliminationPlan::Closing& closing = plan_.closings[c];
  ClosingFactor& f = closing_[c];
  const int n = rows_of_closing(c);
  for (int k = 0; k < n; ++k)
    for (int r = k + 1; r < n; ++r) f.gamma[r] -= f.L(r, k) * f.gamma[k];
  for (int k = 0; k < n; ++k) {
    const S scaled = f.inverse[k] * f.gamma[k];
    if (closing.column_slot >= 0) {
      body->r += scaled * f.C.r.col(k);
      body->x += scaled * f.C.x.col(k);
    }
    for (const EliminationPlan::Neighbour& next : closing.later)
      for (int m = 0; m < rows_of_closing(next.closing); ++m)
        closing_[next.closing].gamma[m] -= scaled * coupling_[next.slot](k, m);
  }
}

template <class S>
void GraphSolver<S>::backward_closing(int c, GraphVector<S>& solution) {
  const EliminationPlan::Closing& closing = plan_.closings[c];
  ClosingFactor& f = closing_[c];
  const int n = rows_of_closing(c);
  Vector6<S>& lambda = solution.edge[closing.edge];
  for (int k = 0; k < n; ++k) {
    S sum = -f.gamma[k];
    if (closing.column_slot >= 0)
      sum +=
          f.C.r.col(k).dot(solution.body[closing.body].r) + f.C.x.col(k).dot(solution.body[closing.body].x);
    for (const EliminationPlan::Neighbour& next : closing.later) {
      const Vector6<S>& theirs = solution.edge[plan_.closings[next.closing].edge];
      for (int m = 0; m < rows_of_closing(next.closing); ++m) sum -= coupling_[next.slot](k, m) * theirs[m];
    }
    lambda[k] = f.inverse[k] * sum;
  }
  for (int k = n - 1; k >= 0; --k)
    for (int r = k + 1; r < n; ++r)
      if (!is_dependent_[closing.edge][k]) lambda[k] -= f.L(r, k) * lambda[r];
}

}  // namespace trivium
