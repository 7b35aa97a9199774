#pragma once
/// Multipliers that are not unique, in the precision of the solve: which combinations of them act on nothing,
/// and the choice among equivalent ones.

#include <algorithm>
#include <utility>
#include <vector>

#include "formulations/analysis/row_analysis.hpp"
#include "formulations/printed/dense_solver.hpp"

namespace trivium {

/// The null space of Phi^T in Scalar, over the rows that the analysis found dependent.
///
/// Which rows are dependent is decided in double (row_analysis.hpp); the combinations themselves are refined
/// until Phi^T N no longer shrinks. Coordinates that are rounded in the scene leave rows that only nearly
/// depend on each other; N is then the least-squares combination, and what Phi^T N keeps is the scene's own
/// ambiguity.
template <class Scalar>
class RedundantMultipliers {
 public:
  RedundantMultipliers(const Mechanism<Scalar>& mechanism, const MechanismState<Scalar>& state,
                       const RowAnalysis& rows) {
    if (rows.null_basis.cols() == 0) return;
    using F = ROmega<Scalar>;
    const auto eom = equations_of_motion<F>(mechanism, to_coordinates<F>(mechanism, state, {}), state.t);
    refine_null_basis(eom, rows);
    weigh(eom, rows);
    gram_.emplace_back(MatrixX<Scalar>(N_.transpose() * E2_.asDiagonal() * N_));
  }

  bool none() const { return gram_.empty(); }

  /// Makes lambda the one of minimum |E lambda| among those with the same Phi^T lambda. Unique components do
  /// not change.
  void to_minimum_norm(VectorX<Scalar>& lambda) const {
    if (none()) return;
    lambda -= N_ * gram_.front().solve(N_.transpose() * E2_.cwiseProduct(lambda));
  }

  /// What the right side of the rows would have to change by, least in E^-1, for rows that miss by `residual`
  /// to agree: the residual's share along the null space.
  VectorX<Scalar> disagreement(const VectorX<Scalar>& residual) const {
    if (none()) return VectorX<Scalar>::Zero(residual.size());
    return E2_.cwiseProduct(N_ * gram_.front().solve(N_.transpose() * residual));
  }

 private:
  using Equations = EquationsOfMotion<ROmega<Scalar>>;

  /// f(body, columns of that body, the row's gradient there) for every body of row k.
  template <class Visit>
  static void for_each_body(const Equations& eom, int k, const Visit& visit) {
    const auto one = [&](int b, const auto& r, const auto& rot) {
      if (b == eom.nb()) return;
      Matrix<Scalar, 1, 6> gradient;
      gradient << r, rot;
      visit(b, gradient);
    };
    one(eom.pair[k].i, eom.row[k].r_i, eom.row[k].rot_i);
    one(eom.pair[k].j, eom.row[k].r_j, eom.row[k].rot_j);
  }

  void refine_null_basis(const Equations& eom, const RowAnalysis& rows) {
    N_ = scalar_cast<Scalar>(rows.null_basis);
    double last = std::numeric_limits<double>::infinity();
    for (int step = 0; step < 8; ++step) {
      MatrixX<Scalar> defect = MatrixX<Scalar>::Zero(6 * eom.nb(), N_.cols());
      for (int k = 0; k < eom.nc(); ++k) {
        if (rows.unique[k]) continue;
        for_each_body(eom, k, [&](int b, const auto& gradient) {
          defect.template middleRows<6>(6 * b) += gradient.transpose() * N_.row(k);
        });
      }
      const MatrixX<double> seen = scalar_cast<double>(defect);
      const double size = seen.cwiseAbs().maxCoeff();
      if (!(size < last / 2) || size == 0) return;
      last = size;
      const MatrixX<double> correction = rows.combination * seen;
      for (std::size_t n = 0; n < rows.independent.size(); ++n)
        if (const int k = rows.independent[n]; !rows.unique[k])
          N_.row(k) -= scalar_cast<Scalar>(correction.row(static_cast<Eigen::Index>(n)));
    }
  }

  /// E_k^2 = Phi_k (metric)^-1 Phi_k^T of the rows in N.
  void weigh(const Equations& eom, const RowAnalysis& rows) {
    E2_ = VectorX<Scalar>::Zero(eom.nc());
    const bool regular = rows.mu.isZero(0);
    std::vector<DenseSolver<Scalar>> metric;
    if (!regular) metric.emplace_back(dense_metric(eom, rows.mu));
    std::vector<Matrix3<Scalar>> J_inverse;
    if (regular)
      for (const auto& J : eom.mass_block) J_inverse.push_back(J.inverse());
    for (int k = 0; k < eom.nc(); ++k) {
      if (rows.unique[k]) continue;
      VectorX<Scalar> whole = VectorX<Scalar>::Zero(regular ? 0 : 6 * eom.nb());
      for_each_body(eom, k, [&](int b, const Matrix<Scalar, 1, 6>& gradient) {
        if (!regular) {
          whole.template segment<6>(6 * b) += gradient.transpose();
          return;
        }
        const Vector3<Scalar> r = gradient.template head<3>(), rot = gradient.template tail<3>();
        E2_[k] += r.squaredNorm() / eom.mass[b] + rot.dot(J_inverse[b] * rot);
      });
      if (!regular) E2_[k] = whole.dot(metric.front().solve(whole));
    }
  }

  /// M + Phi^T diag(mu) Phi.
  static MatrixX<Scalar> dense_metric(const Equations& eom, const VectorX<double>& mu) {
    MatrixX<Scalar> H = MatrixX<Scalar>::Zero(6 * eom.nb(), 6 * eom.nb());
    for (int b = 0; b < eom.nb(); ++b) {
      H.template block<3, 3>(6 * b, 6 * b).diagonal().setConstant(eom.mass[b]);
      H.template block<3, 3>(6 * b + 3, 6 * b + 3) = eom.mass_block[b];
    }
    for (int k = 0; k < eom.nc(); ++k)
      for_each_body(eom, k, [&](int a, const Matrix<Scalar, 1, 6>& gradient_a) {
        for_each_body(eom, k, [&](int b, const Matrix<Scalar, 1, 6>& gradient_b) {
          H.template block<6, 6>(6 * a, 6 * b) += Scalar(mu[k]) * gradient_a.transpose() * gradient_b;
        });
      });
    return H;
  }

  MatrixX<Scalar> N_;
  VectorX<Scalar> E2_;
  std::vector<DenseSolver<Scalar>> gram_;  ///< N^T E^2 N; empty where all rows are independent
};

}  // namespace trivium
