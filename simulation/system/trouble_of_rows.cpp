/// Compares the row analyses at two states, and names the row that a singular position concerns most.

#include "simulation/system/trouble_of_rows.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "bodies/rotations/so3.hpp"
#include "formulations/analysis/row_analysis.hpp"

namespace trivium {

namespace {

/// A message about drivers that depend on other rows and contradict them; empty if there are none.
std::string contradicting_drivers(const std::vector<std::string>& row_names, const RowAnalysis& rows,
                                  const std::vector<int>& drivers, double t) {
  for (const int row : rows.contradictory) {
    // the rows that its dependence involves
    const VectorX<double> share = (rows.null_basis * rows.null_basis.row(row).transpose()).cwiseAbs();
    std::vector<std::string> involved;
    for (const int driver : drivers)
      if (share[driver] > 1e-6 * share.maxCoeff())
        involved.push_back(fmt::format("driver \"{}\"", row_names[driver]));
    if (!involved.empty())
      return fmt::format(
          "{}: what is demanded at t = {} contradicts the other rows, so no acceleration satisfies all. Make "
          "the functions of time consistent, or leave a driver out",
          fmt::join(involved, ", "), t);
  }
  return {};
}

/// The row with the largest share in the combination of rows that has, or comes closest to, the gradient 0.
/// Of `rank` rows that were independent before, it is the next combination to lose its gradient: the left
/// singular vector of the least singular value, by inverse iteration with the factor R of these rows.
Eigen::Index nearest_to_dependent(const TangentSystem& now, int rank) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const Eigen::ColPivHouseholderQR<MatrixX<double>> qr(now.Phi.rowwise().normalized().transpose());
  MatrixX<double> R = qr.matrixR().topLeftCorner(rank, rank);
  for (double& pivot : R.diagonal())
    if (std::abs(pivot) < epsilon) pivot = epsilon;  // instead of a division by 0
  VectorX<double> share = VectorX<double>::Unit(rank, rank - 1);
  for (int iteration = 0; iteration < 5; ++iteration) {
    R.transpose().triangularView<Eigen::Lower>().solveInPlace(share);
    R.triangularView<Eigen::Upper>().solveInPlace(share);
    share.normalize();
  }
  VectorX<double> of_row = VectorX<double>::Zero(now.Phi.rows());
  for (Eigen::Index k = 0; k < rank; ++k) of_row[qr.colsPermutation().indices()[k]] = std::abs(share[k]);
  Eigen::Index row = 0;
  for (Eigen::Index k = 1; k < of_row.size(); ++k)
    if (of_row[k] > 1.01 * of_row[row]) row = k;  // of equal shares, as by symmetry, the first
  return row;
}

/// Whether a condition number of the rows grows within `horizon`, as 1 / (t* - t)^2 does before a singular
/// position at t*. A negative horizon looks back, at a position just passed.
bool grows(double kappa, double horizon, const std::function<double(double)>& kappa_after) {
  const double dt = 1e-3 * horizon, growth = (kappa_after(dt) - kappa) / dt;
  const double left = 2 * kappa / growth;  // until t*
  const double share = left / horizon;
  return share > 0 && share < 1 && kappa_after(0.9 * left) > 10 * kappa;
}

}  // namespace

MechanismState<double> coasted(MechanismState<double> state, double dt) {
  for (std::size_t b = 0; b < state.pose.size(); ++b) {
    const Twist<double>& twist = state.twist[b];
    state.pose[b].r += dt * twist.r_dot;
    state.pose[b].p =
        multiply_parameters(state.pose[b].p, exponential_parameters(Vector3<double>(dt * twist.omega_bar)));
  }
  return state;
}

std::string trouble_of_rows(const std::vector<std::string>& row_names, const std::vector<int>& drivers,
                            double start, const TangentSystem& at_start, double t,
                            const std::function<TangentSystem(double)>& after) {
  // Each row is divided by its size, which depends on the position. So the condition number of three rows of
  // a spherical joint changes by 40 where the body is slender.
  constexpr double much = 1000, some = 10;
  const TangentSystem now = after(0);
  const RowAnalysis then = analyse_rows(at_start), here = analyse_rows(now);
  const bool is_near = here.rank < then.rank || here.kappa > much * then.kappa;
  const auto grows_within = [&](double horizon) {
    return grows(here.kappa, horizon, [&](double dt) { return analyse_rows(after(dt)).kappa; });
  };
  const double horizon = (t - start) / 50;
  std::string beside;
  if (!is_near && here.kappa > some * then.kappa) {
    if (grows_within(horizon))
      beside = ", and it goes on to grow";
    else if (grows_within(-horizon))
      beside = ", and it was larger just before";
  }
  if (!is_near && beside.empty()) return contradicting_drivers(row_names, here, drivers, t);
  return fmt::format(
      "near a singular position, where row \"{}\" comes to depend on others and the mechanism can go on in "
      "more than one way: since the start {}{}. Try other tolerances or steps, or another of dopri5, "
      "rkf78 and rattle, which pass most singular positions",
      row_names[nearest_to_dependent(now, std::max(then.rank, 1))],
      here.rank < then.rank
          ? fmt::format("the rank of the rows has fallen from {} to {}", then.rank, here.rank)
          : fmt::format("the condition number of the rows has grown from {:.1e} to {:.1e}", then.kappa,
                        here.kappa),
      beside);
}

}  // namespace trivium
