/// Solves each formulation with its AccelerationSolver and completes the result with sums over bodies and
/// rows: the norms E, the multipliers of internal rows, residuals and joint reactions.

#include "formulations/structured_side_by_side.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "base/raise.hpp"
#include "bodies/inertia.hpp"
#include "bodies/rotations/so3.hpp"
#include "formulations/euler_chart_choice.hpp"
#include "formulations/near_singular_chart.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/side_by_side_impl.hpp"
#include "formulations/structured/acceleration_solver.hpp"

namespace trivium {

namespace {

using Equations = EquationsOfMotion<ROmega<double>>;

Equations equations_at(const Model<double>& model) {
  return equations_of_motion<ROmega<double>>(
      model.mechanism, to_coordinates<ROmega<double>>(model.mechanism, model.state, {}), model.state.t);
}

/// The norms of row_norms.hpp, computed row by row from a regular block-diagonal M; empty if an inertia is
/// singular.
void find_norms(const Equations& eom, RowNorms& out) {
  std::vector<Eigen::LLT<Matrix3<double>>> J;
  VectorX<double> reach = VectorX<double>::Zero(6 * (eom.nb() + 1));  // M^-1 |Q|; 0 for the ground
  VectorX<double> scale(6 * eom.nb());
  double bound = 0;
  for (int b = 0; b < eom.nb(); ++b) {
    const Matrix3<double>& inertia = eom.mass_block[b];
    J.emplace_back(inertia);
    if (J.back().info() != Eigen::Success || !(J.back().rcond() > inertia_tolerance)) return;
    scale.segment<3>(6 * b).setConstant(std::sqrt(eom.mass[b]));
    scale.segment<3>(6 * b + 3) = inertia.diagonal().cwiseSqrt();
    reach.segment<3>(6 * b) = eom.F_applied[b].cwiseAbs() / eom.mass[b];
    reach.segment<3>(6 * b + 3) = J[b].solve(Vector3<double>(eom.tau[b].cwiseAbs())).cwiseAbs();
    bound += eom.F_applied[b].squaredNorm() / eom.mass[b] + eom.tau[b].dot(J[b].solve(eom.tau[b]));
  }
  out.acceleration_scale = scale;
  out.mu = VectorX<double>::Zero(eom.nc());
  out.E.resize(eom.nc());
  out.schur_rhs_bound.resize(eom.nc());
  double of_rows = 0;
  for (int k = 0; k < eom.nc(); ++k) {
    const auto& row = eom.row[k];
    double square = 0, size = std::abs(row.gamma);
    const auto add = [&](int b, const auto& r, const auto& rot) {
      size += r.cwiseAbs().dot(reach.segment<3>(6 * b)) + rot.cwiseAbs().dot(reach.segment<3>(6 * b + 3));
      if (b == eom.nb()) return;
      square += r.squaredNorm() / eom.mass[b] + rot.dot(J[b].solve(Vector3<double>(rot.transpose())));
    };
    add(eom.pair[k].i, row.r_i, row.rot_i);
    add(eom.pair[k].j, row.r_j, row.rot_j);
    out.E[k] = std::sqrt(square);
    out.schur_rhs_bound[k] = size;
    if (square > 0) of_rows += row.gamma * row.gamma / square;
  }
  out.acceleration_bound = std::sqrt(bound) + std::sqrt(of_rows);
}

template <Formulation F>
RowAnalysis rows_of(const Model<double>& model, AccelerationSolver<F>& solver) {
  RowAnalysis rows;
  rows.dependent = solver.dependent_rows();
  std::sort(rows.dependent.begin(), rows.dependent.end());
  for (int k = 0; k < model.mechanism.nc(); ++k)
    if (!std::binary_search(rows.dependent.begin(), rows.dependent.end(), k)) rows.independent.push_back(k);
  rows.rank = static_cast<int>(rows.independent.size());
  rows.unique = rows.dependent.empty() ? std::vector<bool>(model.mechanism.nc(), true) : solver.unique();
  rows.kappa = std::numeric_limits<double>::quiet_NaN();
  find_norms(equations_at(model), rows);
  return rows;
}

/// How far the solution moves if every body is turned by some roundings of its orientation. Near the
/// singularity of a chart the equations themselves are rounded by far more than u, which the corrections of
/// the solver do not show. Several tries, as roundings often are the same again.
template <Formulation F>
Corrections change_by_rounding(const Model<double>& model, const ChartOptions& charts,
                               const AccelerationSolver<F>& solver) {
  const auto of_bodies = [nb = model.mechanism.nb()](const AccelerationSolver<F>& of) {
    VectorX<double> all(6 * nb);
    for (int b = 0; b < nb; ++b) all.segment<6>(6 * b) << of.r_ddot(b), of.omega_bar_dot(b);
    return all;
  };
  const auto change = [](const VectorX<double>& x, const VectorX<double>& y) {
    const double size = largest_magnitude(x);
    return size > 0 ? largest_magnitude(VectorX<double>(y - x)) / size : 0;
  };
  AccelerationSolver<F> near(model.mechanism);
  Corrections largest;
  std::minstd_rand random;
  for (int tries = 0; tries < 12; ++tries) {
    MechanismState<double> state = model.state;
    for (Pose<double>& pose : state.pose) {
      Vector4<double> turn(1, 0, 0, 0);
      for (int k = 1; k < 4; ++k)
        turn[k] = unit_roundoff<double>() * (static_cast<double>(random() % 65) - 32);
      pose.p = multiply_parameters(pose.p, turn);
    }
    try {
      near.solve(to_coordinates<F>(model.mechanism, state, charts), state.t);
    } catch (const ModelError&) {
      return {1, 1};  // a rounding decides whether there is a solution: no digit is known
    }
    raise(largest.lambda, change(solver.lambda(), near.lambda()));
    raise(largest.acceleration, change(of_bodies(solver), of_bodies(near)));
  }
  return largest;
}

template <Formulation F>
FormulationResult<double> solve_one(const Model<double>& model, const RowAnalysis& rows,
                                    const ChartOptions& charts) {
  const Mechanism<double>& mechanism = model.mechanism;
  const auto state = to_coordinates<F>(mechanism, model.state, charts);
  AccelerationSolver<F> solver(mechanism);
  const std::string near_chart = near_singular_chart<F>(mechanism, state, model.state.t, reframing_distance);
  try {
    solver.solve(state, model.state.t);
  } catch (const ModelError& error) {
    // r-omega has a solution here (structured_row_analysis), so that the coordinates are at fault
    if (near_chart.empty()) throw;
    throw ModelError(Place{}, Error(ErrorKind::model, near_chart + "; the solver ended with: " + error.what(),
                                    Place{error.where(), model.state.t}));
  }
  const auto eom = equations_of_motion<F>(mechanism, state, model.state.t);
  FormulationResult<double> result;
  Unknowns<F> found;
  found.body.resize(mechanism.nb() + 1);  // zero for the ground
  for (int b = 0; b < mechanism.nb(); ++b) {
    found.body[b] = {solver.r_ddot(b), solver.q_ddot(b)};
    result.solution.r_ddot.push_back(solver.r_ddot(b));
    result.solution.omega_bar_dot.push_back(solver.omega_bar_dot(b));
    if (const std::string chart(state[b].chart.name()); !chart.empty()) result.charts.push_back(chart);
  }
  found.lambda = solver.lambda();
  // the multipliers of the internal rows balance the residual of the rotational equations of each body
  constexpr int internal = F::internal_constraints;
  std::vector<typename F::Unknown> left(mechanism.nb() + 1, F::Unknown::Zero());
  for (int b = 0; b < mechanism.nb(); ++b) left[b] = eom.tau[b] - eom.mass_block[b] * found.body[b].q_ddot;
  for (int k = 0; k < mechanism.nc(); ++k) {
    left[eom.pair[k].i] -= found.lambda[k] * eom.row[k].rot_i.transpose();
    left[eom.pair[k].j] -= found.lambda[k] * eom.row[k].rot_j.transpose();
  }
  found.lambda_internal.resize(internal * mechanism.nb());
  if constexpr (internal > 0)
    for (int b = 0; b < mechanism.nb(); ++b) {
      const Matrix<double, internal, F::rotational_unknowns> P = F::internal_jacobian(eom.body[b]);
      found.lambda_internal.template segment<internal>(internal * b) =
          (P * P.transpose()).llt().solve(P * left[b]);
    }
  result.lambda_internal = found.lambda_internal;
  result.residual = matrix_free_residual<F>(mechanism, eom, found, rows.dependent);
  const double u = unit_roundoff<double>();
  result.estimate = {solver.corrections().lambda + u, solver.corrections().acceleration + u};
  if (!near_chart.empty()) {
    const Corrections change = change_by_rounding<F>(model, charts, solver);
    raise(result.estimate.lambda, change.lambda);
    raise(result.estimate.acceleration, change.acceleration);
  }
  // without a norm E there is no choice of least norm: the solver's lambda is 0 in dependent rows
  const bool has_choice = !rows.dependent.empty() && rows.E.size() > 0;
  result.solution.lambda = has_choice ? solver.minimum_norm_lambda() : found.lambda;
  for (const Joint<double>& joint : mechanism.joints)
    result.reactions.push_back(
        joint_reaction<F>(eom, joint, result.solution.lambda, End::j).about(joint_point<F>(eom, joint)));
  return result;
}

}  // namespace

RowAnalysis structured_row_analysis(const Model<double>& model) {
  AccelerationSolver<ROmega<double>> solver(model.mechanism);
  solver.solve(to_coordinates<ROmega<double>>(model.mechanism, model.state, {}), model.state.t);
  return rows_of(model, solver);
}

SideBySide<double> structured_side_by_side(const Model<double>& model, const SolveOptions& options) {
  SideBySide<double> out{structured_row_analysis(model), {}};
  detail::solve_each(formulation_names(), options, model.state.t, out, [&](const std::string& name) {
    return with_formulation<double>(
        name, [&]<Formulation F>() { return solve_one<F>(model, out.rows, options.charts); });
  });
  return out;
}

}  // namespace trivium
