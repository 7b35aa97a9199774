/// The norms by solutions with the factored mass metric.

#include "formulations/analysis/row_norms.hpp"

#include <algorithm>
#include <utility>

#include "base/raise.hpp"

namespace trivium {

VectorX<double> inverse_or_zero(const VectorX<double>& v) {
  return v.unaryExpr([](double x) { return x > 0 ? 1 / x : 0.0; });
}

namespace {

/// |Phi| M^-1 |Q| + |gamma| from the magnitudes, where nothing cancels.
VectorX<double> size_uncancelled(const Magnitudes& sizes, const MassMetric& metric) {
  const VectorX<double> reach = metric.half_solve_transposed(metric.half_solve(sizes.Q));
  VectorX<double> bound = sizes.gamma;
  for (Eigen::Index k = 0; k < bound.size(); ++k) {
    const auto& [bodies, r, rot_i, rot_j] = sizes.rows[k];
    for (const auto& [b, rot] : {std::pair{bodies.i, rot_i}, {bodies.j, rot_j}})
      if (6 * b < reach.size())
        bound[k] += r * reach.segment<3>(6 * b).norm() + rot * reach.segment<3>(6 * b + 3).norm();
  }
  return bound;
}

}  // namespace

RowNorms row_norms(const TangentSystem& s, const MassMetric& metric, const MatrixX<double>& W) {
  RowNorms out;
  out.mu = metric.mu();
  out.acceleration_scale = metric.diagonal().cwiseSqrt();
  out.acceleration_bound = metric.half_solve(s.Q).norm();
  const Magnitudes& sizes = s.magnitudes;
  const bool by_magnitude = sizes.Q.size() > 0;
  double acceleration_by_magnitude = by_magnitude ? metric.half_solve(sizes.Q).norm() : 0.0;
  if (s.Phi.rows() > 0) {
    out.E = W.colwise().norm();
    const VectorX<double> E_inverse = inverse_or_zero(out.E);
    // absolute values of M^-1 |Q| too: a metric that couples coordinates can make components negative
    out.schur_rhs_bound =
        s.Phi.cwiseAbs() * metric.half_solve_transposed(metric.half_solve(s.Q.cwiseAbs())).cwiseAbs() +
        s.gamma.cwiseAbs();
    out.acceleration_bound += E_inverse.cwiseProduct(s.gamma).norm();
    if (by_magnitude) {
      out.schur_rhs_bound_uncancelled = size_uncancelled(sizes, metric);
      out.schur_rhs_bound =
          out.schur_rhs_bound.cwiseMax(cancellation_floor * out.schur_rhs_bound_uncancelled);
      acceleration_by_magnitude += E_inverse.cwiseProduct(sizes.gamma).norm();
    }
  }
  raise(out.acceleration_bound, cancellation_floor * acceleration_by_magnitude);
  return out;
}

}  // namespace trivium
