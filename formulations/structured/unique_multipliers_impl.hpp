#pragma once
/// AccelerationSolver: which multipliers are unique, and the multipliers of minimum norm. Both use a basis of
/// the null space of Phi_q^T, one vector per dependent row. A part of acceleration_solver_impl.hpp.

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>

#include "bodies/numbers/scalar.hpp"
#include "formulations/structured/acceleration_solver.hpp"

namespace trivium {

template <Formulation F>
MatrixX<typename F::Scalar> AccelerationSolver<F>::left_null_space() {
  const std::vector<int> dependent = dependent_rows();
  MatrixX<S> N = MatrixX<S>::Zero(mechanism_.nc(), static_cast<Eigen::Index>(dependent.size()));
  GraphVector<S> unit(solver_.plan().graph), combination(unit);
  for_each_row([&](int edge, int k, int row) {
    if (!solver_.is_dependent(edge, k)) return;
    const auto n = std::lower_bound(dependent.begin(), dependent.end(), row) - dependent.begin();
    // solves for the combination of independent rows that, added to this row, exerts no force on any body
    std::fill(unit.body.begin(), unit.body.end(), BodyPart<S>{});
    solver_.add_row({edge, k}, S(-1), unit);
    solver_.solve(unit, combination);
    for_each_row([&](int other, int m, int other_row) { N(other_row, n) = combination.edge[other][m]; });
    N(row, n) = S(1);
  });
  return N;
}

template <Formulation F>
template <class Norm2>
VectorX<typename F::Scalar> AccelerationSolver<F>::row_sizes(const Norm2& norm2) const {
  const EliminationPlan& plan = solver_.plan();
  VectorX<S> E2 = VectorX<S>::Zero(mechanism_.nc());
  const auto add = [&](int body, int row, const Padded<S>& r, const Padded<S>& x) {
    if (body != plan.graph.bodies) E2[row] += norm2(body, unpadded<S>(r), unpadded<S>(x));
  };
  for (const auto& joint : assembly_.links()) {
    const EliminationPlan::Link& link = plan.links[joint.link];
    const PointRows<S>& rows = assembly_.matrix().point[joint.link];
    const std::vector<int>& row = plan.graph.edges[joint.edge].rows;
    for (int k = 0; k < static_cast<int>(row.size()); ++k) {
      const bool is_point = k < 3;
      const Padded<S> r = is_point ? padded<S>(Vector3<S>::Unit(k)) : Padded<S>(Padded<S>::Zero());
      add(link.body, row[k], r, is_point ? rows.L_child.col(k) : rows.W_child.col(k - 3));
      add(link.parent, row[k], r, is_point ? rows.L_parent.col(k) : rows.W_parent.col(k - 3));
    }
  }
  for (std::size_t e = 0; e < plan.graph.edges.size(); ++e) {
    if (plan.rows_slot[e] < 0) continue;
    const GraphEdge& edge = plan.graph.edges[e];
    const EdgeRows<S>& rows = assembly_.matrix().rows[plan.rows_slot[e]];
    for (int k = 0; k < edge.size(); ++k) {
      add(edge.i, edge.rows[k], rows.C_i.r.col(k), rows.C_i.x.col(k));
      add(edge.j, edge.rows[k], rows.C_j.r.col(k), rows.C_j.x.col(k));
    }
  }
  return E2;
}

template <Formulation F>
std::vector<bool> AccelerationSolver<F>::unique() {
  std::vector<bool> flags(mechanism_.nc(), true);
  const MatrixX<S> N = left_null_space();
  if (N.cols() == 0) return flags;
  // lever2() below needs the levers of the bodies, which solve() does not measure at every state
  solver_.measure_levers();
  // A multiplier is not unique if its row is dependent and has no gradient, or if the row has more than a
  // negligible share in a null space vector. The share is the coefficient times the norm of the row's
  // gradient. In this norm the rotational part is divided by the lever, a length that is the same for all
  // bodies that joints connect.
  const VectorX<S> size2 = row_sizes([&](int b, const Vector3<S>& r, const Vector3<S>& x) {
    return S(r.squaredNorm() + x.squaredNorm() / solver_.lever2(b));
  });
  const S negligible = direction_tolerance<S>(mechanism_.rank_tolerance);
  for (Eigen::Index n = 0; n < N.cols(); ++n) {
    S largest(0);
    for (int row = 0; row < mechanism_.nc(); ++row) {
      const S size = N(row, n) * N(row, n) * size2[row];
      largest = select(size > largest, size, largest);
    }
    for (int row = 0; row < mechanism_.nc(); ++row)
      if (N(row, n) * N(row, n) * size2[row] > negligible * negligible * largest ||
          (size2[row] == S(0) && N(row, n) != S(0)))
        flags[row] = false;
  }
  return flags;
}

template <Formulation F>
VectorX<typename F::Scalar> AccelerationSolver<F>::minimum_norm_lambda() {
  VectorX<S> all = lambda();
  const MatrixX<S> N = left_null_space();
  if (N.cols() == 0) return all;
  const VectorX<S> E2 = row_sizes([&](int b, const Vector3<S>& r, const Vector3<S>& x) {
    const Matrix3<S> J = assembly_.matrix().H[b].xx.template topRows<3>();
    // The determinant is the product of the principal moments, trace / 3 is their mean. If the product is at
    // most u mean^3, the smallest moment may be rounding error of the others, and J counts as singular.
    const S moments = J.trace() / 3;
    if (!(J.determinant() > unit_roundoff<S>() * moments * moments * moments))
      throw ModelError({fmt::format("body \"{}\"", mechanism_.body_names[b]), static_cast<double>(t_)},
                       "the inertia of the body is singular, so the norm |E lambda| is not defined: take the "
                       "printed system for the multipliers of minimum norm");
    return S(r.squaredNorm() / mechanism_.bodies[b].mass + x.dot(J.inverse() * x));
  });
  const MatrixX<S> gram = N.transpose() * E2.asDiagonal() * N;
  return all - N * gram.ldlt().solve(N.transpose() * E2.cwiseProduct(all));
}

}  // namespace trivium
