#pragma once
/// The residual of a solution in the equations of motion of each body and row. No matrix is formed, so
/// errors of forming a matrix become visible.

#include <cmath>
#include <vector>

#include "base/raise.hpp"
#include "bodies/numbers/lanewise.hpp"
#include "bodies/numbers/scalar.hpp"
#include "constraints/constraint_row.hpp"
#include "formulations/printed/augmented_system.hpp"

namespace trivium {

/// The largest relative residuals [-] of the bodies' equations and of the rows, without an assembled matrix.
/// The residual of a body's equation is divided by the sum of the magnitudes of its terms. The residual Phi''
/// of a row is divided by |gamma| plus the magnitudes of the gradient times accelerations. The accelerations
/// of the solution may be zero while large forces are in balance. So the accelerations are taken that the sum
/// of the magnitudes of these forces would give to the body. The rows listed in `dependent` are reported
/// separately, because the solver omits them.
struct MatrixFreeResidual {
  double bodies = 0, rows = 0, dependent_rows = 0;
  double worst() const { return larger(bodies, rows); }
};

/// The residuals of the unknowns u. `dependent` has the indices of the dependent rows.
template <EquationsAsPrinted F, class Types>
MatrixFreeResidual matrix_free_residual(const Mechanism<typename F::Scalar, Types>& mechanism,
                                        const EquationsOfMotion<F>& eom, const Unknowns<F>& u,
                                        const std::vector<int>& dependent = {}) {
  using S = typename F::Scalar;
  using std::abs;
  const int nb = eom.nb();
  struct BodyBalance {
    Vector3<S> r = Vector3<S>::Zero();
    typename F::Unknown q = F::Unknown::Zero();
    S r_scale{0}, q_scale{0};
    void add_r(const Vector3<S>& term) {
      r += term;
      r_scale += term.norm();
    }
    void add_q(const typename F::Unknown& term) {
      q += term;
      q_scale += term.norm();
    }
  };
  std::vector<BodyBalance> balance(nb + 1);
  for (int b = 0; b < nb; ++b) {
    balance[b].add_r(eom.mass[b] * u.body[b].r_ddot);
    balance[b].add_r(-eom.F_applied[b]);
    balance[b].add_q(eom.mass_block[b] * u.body[b].q_ddot);
    balance[b].add_q(-eom.tau[b]);
    const Matrix<S, F::internal_constraints, F::rotational_unknowns> P = F::internal_jacobian(eom.body[b]);
    balance[b].add_q(P.transpose() * u.lambda_internal.template segment<F::internal_constraints>(
                                         F::internal_constraints * b));
  }
  MatrixFreeResidual residual;
  // The terms of a body at rest in a moving mechanism are rounding errors, some u times the largest term, and
  // give no scale. The scale is therefore at least sqrt(u) times the largest scale in the mechanism: far
  // above such rounding errors, far below the terms of a body that moves.
  S largest(0);
  using std::sqrt;
  const S negligible = sqrt(unit_roundoff<S>());
  const auto raise_relative = [&](double& worst, const S& value, const S& own_scale) {
    if (value == S(0)) return;
    const S least = negligible * largest, scale = own_scale < least ? least : own_scale;
    raise(worst, static_cast<double>(S(value / scale)));
  };
  std::vector<bool> is_dependent(mechanism.rows.size(), false);
  for (int k : dependent) is_dependent[k] = true;
  for (int k = 0; k < eom.nc(); ++k) {
    const auto [i, j] = eom.pair[k];
    const auto& row = eom.row[k];
    balance[i].add_r(u.lambda[k] * row.r_i.transpose());
    balance[i].add_q(u.lambda[k] * row.rot_i.transpose());
    balance[j].add_r(u.lambda[k] * row.r_j.transpose());
    balance[j].add_q(u.lambda[k] * row.rot_j.transpose());
  }
  // The accelerations by the sum of the magnitudes of the forces on a body. |q''| is added, because the
  // forces do not determine all of q'': in r-p, J^p p = 0 and the component of p'' along p comes from the
  // internal row.
  struct Reach {
    S r{0}, q{0};
  };
  std::vector<Reach> reach(nb + 1);
  for (int b = 0; b < nb; ++b) {
    reach[b] = {balance[b].r_scale / eom.mass[b], u.body[b].q_ddot.norm()};
    if (const S J = eom.mass_block[b].norm(); J > S(0)) reach[b].q += balance[b].q_scale / J;
  }
  std::vector<S> row_scale(eom.nc()), row_residual(eom.nc());
  for (int k = 0; k < eom.nc(); ++k) {
    const auto [i, j] = eom.pair[k];
    const auto& row = eom.row[k];
    const S phi_ddot =
        row_acceleration(mechanism.rows[k], eom.body[i], eom.body[j], eom.t, u.body[i], u.body[j]);
    row_residual[k] = abs(phi_ddot);
    row_scale[k] = abs(row.gamma) + row.r_i.norm() * reach[i].r + row.r_j.norm() * reach[j].r +
                   row.rot_i.norm() * reach[i].q + row.rot_j.norm() * reach[j].q;
    if (row_scale[k] > largest) largest = row_scale[k];
  }
  for (int k = 0; k < eom.nc(); ++k)
    raise_relative(is_dependent[k] ? residual.dependent_rows : residual.rows, row_residual[k], row_scale[k]);
  largest = S(0);
  for (int b = 0; b < nb; ++b)
    for (const S& scale : {balance[b].r_scale, balance[b].q_scale})
      if (scale > largest) largest = scale;
  for (int b = 0; b < nb; ++b) {
    raise_relative(residual.bodies, balance[b].r.norm(), balance[b].r_scale);
    raise_relative(residual.bodies, balance[b].q.norm(), balance[b].q_scale);
  }
  return residual;
}

}  // namespace trivium
