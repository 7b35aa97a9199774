#pragma once
/// The definitions of redundant_multipliers.hpp, compiled in instances/ for float to Real50. Include this
/// file only for a Scalar without an instance.

#include <limits>
#include <utility>

#include "bodies/numbers/scalar.hpp"
#include "formulations/printed/redundant_multipliers.hpp"

namespace trivium {

template <class Scalar>
RedundantMultipliers<Scalar>::RedundantMultipliers(const Equations& eom, const RowAnalysis& rows) {
  refine_null_basis(eom, rows);
  weigh(eom, rows);
  gram_.emplace_back(MatrixX<Scalar>(N_.transpose() * E2_.asDiagonal() * N_));
}

template <class Scalar>
void RedundantMultipliers<Scalar>::to_minimum_norm(VectorX<Scalar>& lambda) const {
  if (none()) return;
  lambda -= N_ * gram_.front().solve(N_.transpose() * E2_.cwiseProduct(lambda));
}

template <class Scalar>
VectorX<Scalar> RedundantMultipliers<Scalar>::disagreement(const VectorX<Scalar>& residual) const {
  if (none()) return VectorX<Scalar>::Zero(residual.size());
  return E2_.cwiseProduct(N_ * gram_.front().solve(N_.transpose() * residual));
}

template <class Scalar>
template <class Visit>
void RedundantMultipliers<Scalar>::for_each_body(const Equations& eom, int k, const Visit& visit) {
  const auto one = [&](int b, const auto& r, const auto& rot) {
    if (b == eom.nb()) return;
    Matrix<Scalar, 1, 6> gradient;
    gradient << r, rot;
    visit(b, gradient);
  };
  one(eom.pair[k].i, eom.row[k].r_i, eom.row[k].rot_i);
  one(eom.pair[k].j, eom.row[k].r_j, eom.row[k].rot_j);
}

template <class Scalar>
void RedundantMultipliers<Scalar>::refine_null_basis(const Equations& eom, const RowAnalysis& rows) {
  N_ = scalar_cast<Scalar>(rows.null_basis);
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < 8;
       ++step) {  // a step gains up to 15 digits, so Real50 needs four steps; 8 is a safety limit
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

template <class Scalar>
void RedundantMultipliers<Scalar>::weigh(const Equations& eom, const RowAnalysis& rows) {
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

template <class Scalar>
MatrixX<Scalar> RedundantMultipliers<Scalar>::dense_metric(const Equations& eom, const VectorX<double>& mu) {
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

}  // namespace trivium
