#include "formulations/row_analysis.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace trivium {

namespace {

bool is_singular(const Matrix3<double>& J) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(J, Eigen::EigenvaluesOnly).eigenvalues()[0] <=
         1e-12 * J.trace();
}

MatrixX<double> mass_matrix(const TangentSystem& s) {
  const Eigen::Index nb = static_cast<Eigen::Index>(s.mass.size());
  MatrixX<double> M = MatrixX<double>::Zero(6 * nb, 6 * nb);
  for (Eigen::Index b = 0; b < nb; ++b) {
    M.block<3, 3>(6 * b, 6 * b).diagonal().setConstant(s.mass[b]);
    M.block<3, 3>(6 * b + 3, 6 * b + 3) = s.inertia[b];
  }
  return M;
}

/// Where the metric cannot be factored: the body that moves most in the direction without mass or constraint.
[[noreturn]] void throw_without_inertia(const TangentSystem& s, const MatrixX<double>& H,
                                        const VectorX<double>& scale) {
  const MatrixX<double> scaled = scale.asDiagonal() * H * scale.asDiagonal();
  const VectorX<double> direction =
      scale.cwiseProduct(Eigen::SelfAdjointEigenSolver<MatrixX<double>>(scaled).eigenvectors().col(0));
  Eigen::Index worst = 0;
  double size = -1;
  for (Eigen::Index b = 0; b < static_cast<Eigen::Index>(s.mass.size()); ++b)
    if (const double turn = direction.segment<3>(6 * b + 3).norm(); turn > size) {
      size = turn;
      worst = b;
    }
  const Vector3<double> axis = direction.segment<3>(6 * worst + 3).normalized().unaryExpr([](double x) {
    return std::abs(x) < 1e-9 ? 0.0 : x;
  });  // the eigenvector's rounding
  throw ModelError(
      fmt::format("body \"{}\" has no inertia about its axis ({:.3g}, {:.3g}, {:.3g}) and no constraint "
                  "holds it there, so its "
                  "acceleration is not determined; give it inertia about that axis or constrain the rotation",
                  s.body_names[worst], axis[0], axis[1], axis[2]));
}

/// Rotations in metres: a rotation column is divided by the lever with which the rows that hold points see
/// rotations.
VectorX<double> geometric_column_scale(const TangentSystem& s) {
  double translation = 0, rotation = 0;
  for (Eigen::Index k = 0; k < s.Phi.rows(); ++k) {
    double r2 = 0, rot2 = 0;
    for (Eigen::Index b = 0; b < static_cast<Eigen::Index>(s.mass.size()); ++b) {
      r2 += s.Phi.block<1, 3>(k, 6 * b).squaredNorm();
      rot2 += s.Phi.block<1, 3>(k, 6 * b + 3).squaredNorm();
    }
    if (r2 == 0) continue;
    translation += 1;
    rotation += rot2 / r2;
  }
  const double lever = translation > 0 && rotation > 0 ? std::sqrt(rotation / translation) : 1.0;
  VectorX<double> scale = VectorX<double>::Ones(s.Phi.cols());
  for (Eigen::Index b = 0; b < static_cast<Eigen::Index>(s.mass.size()); ++b)
    scale.segment<3>(6 * b + 3).setConstant(1 / lever);
  return scale;
}

VectorX<double> inverse_or_zero(const VectorX<double>& v) {
  return v.unaryExpr([](double x) { return x > 0 ? 1 / x : 0.0; });
}

/// The last rows, as far as possible, that the others determine: rows of the null basis picked from the end
/// so that they stay well conditioned.
std::vector<int> choose_redundant(const MatrixX<double>& Z) {
  const Eigen::Index d = Z.cols();
  for (double threshold = 0.1;; threshold /= 10) {
    std::vector<int> chosen;
    MatrixX<double> basis(d, 0);
    for (Eigen::Index k = Z.rows() - 1; k >= 0 && static_cast<Eigen::Index>(chosen.size()) < d; --k) {
      VectorX<double> rest = Z.row(k).transpose();
      for (int pass = 0; pass < 2; ++pass) rest -= basis * (basis.transpose() * rest);
      const double size = rest.norm();
      if (size <= threshold * Z.row(k).norm() || size <= 0.1 * threshold) continue;
      basis.conservativeResize(d, basis.cols() + 1);
      basis.col(basis.cols() - 1) = rest / size;
      chosen.push_back(static_cast<int>(k));
    }
    if (static_cast<Eigen::Index>(chosen.size()) == d) {
      std::reverse(chosen.begin(), chosen.end());
      return chosen;
    }
    if (threshold < 1e-12) throw ModelError("the null space of the constraint rows could not be resolved");
  }
}

void decide_rank(const TangentSystem& s, RowAnalysis& out) {
  const int nc = static_cast<int>(s.Phi.rows());
  out.unique.assign(nc, true);
  MatrixX<double> rows = s.Phi * geometric_column_scale(s).asDiagonal();
  const VectorX<double> row_scale = inverse_or_zero(rows.rowwise().norm());
  rows = row_scale.asDiagonal() * rows;
  Eigen::ColPivHouseholderQR<MatrixX<double>> qr;
  qr.setThreshold(rank_tolerance);
  qr.compute(rows.transpose());
  const int rank = static_cast<int>(qr.rank()), defect = nc - rank;
  out.rank = rank;

  // a row without a gradient holds nothing: it is redundant, and has no share in the null basis
  std::vector<Eigen::Index> dependent;
  for (int d = 0; d < defect; ++d) {
    const int k = qr.colsPermutation().indices()[rank + d];
    if (row_scale[k] > 0)
      dependent.push_back(d);
    else
      out.unique[k] = false;
  }
  const Eigen::Index null = static_cast<Eigen::Index>(dependent.size());
  MatrixX<double> Z(nc, null);  // combinations of the scaled rows that vanish
  if (null > 0) {
    const auto& R = qr.matrixR();
    const MatrixX<double> shares = R.topRightCorner(rank, defect)(Eigen::all, dependent);
    Z << R.topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solve(-shares),
        MatrixX<double>(MatrixX<double>::Identity(defect, defect)(Eigen::all, dependent));
    Z = qr.colsPermutation() * Z;
    Z = (Eigen::HouseholderQR<MatrixX<double>>(Z).householderQ() * MatrixX<double>::Identity(nc, null))
            .eval();
    for (int k = 0; k < nc; ++k)
      if (Z.row(k).norm() > rank_tolerance)
        out.unique[k] = false;
      else
        Z.row(k).setZero();
    out.redundant = choose_redundant(Z);
  }
  for (int k = 0; k < nc; ++k)
    if (row_scale[k] == 0) out.redundant.push_back(k);
  std::sort(out.redundant.begin(), out.redundant.end());
  for (int k = 0; k < nc; ++k)
    if (!std::binary_search(out.redundant.begin(), out.redundant.end(), k)) out.independent.push_back(k);

  // to combinations of the rows themselves, orthonormal in E
  const VectorX<double> to_E = out.E.cwiseProduct(row_scale);
  const MatrixX<double> EN = to_E.asDiagonal() * Z;
  if (null > 0) {
    MatrixX<double> Q =
        Eigen::HouseholderQR<MatrixX<double>>(EN).householderQ() * MatrixX<double>::Identity(nc, null);
    for (int k = 0; k < nc; ++k)
      if (out.unique[k]) Q.row(k).setZero();
    out.null_basis = inverse_or_zero(out.E).asDiagonal() * Q;
  } else {
    out.null_basis.resize(nc, 0);
  }
}

/// Redundant rows: gamma_k against what the independent rows make of it.
void find_contradictions(const TangentSystem& s, RowAnalysis& out) {
  if (out.redundant.empty()) return;
  MatrixX<double> rows = s.Phi * geometric_column_scale(s).asDiagonal();
  VectorX<double> gamma = s.gamma;
  for (Eigen::Index k = 0; k < gamma.size(); ++k) {
    const double size = rows.row(k).norm();
    if (size == 0) continue;
    rows.row(k) /= size;
    gamma[k] /= size;
  }
  // the least acceleration that meets the independent rows shows what they make of the others
  VectorX<double> acceleration = VectorX<double>::Zero(rows.cols());
  if (out.rank > 0) {
    const MatrixX<double> independent = rows(out.independent, Eigen::all).transpose();
    const Eigen::HouseholderQR<MatrixX<double>> qr(independent);
    const MatrixX<double> R = qr.matrixQR().topRows(out.rank);
    const VectorX<double> y = R.transpose().triangularView<Eigen::Lower>().solve(gamma(out.independent));
    const MatrixX<double> Q = qr.householderQ() * MatrixX<double>::Identity(rows.cols(), out.rank);
    acceleration = Q * y;
  }
  const double largest = std::max(gamma.cwiseAbs().maxCoeff(), acceleration.norm());
  for (int k : out.redundant)
    if (std::abs(rows.row(k).dot(acceleration) - gamma[k]) > contradiction_tolerance * largest + 1e-12)
      out.contradictory.push_back(k);
}

}  // namespace

Metric::Metric(const TangentSystem& system) {
  const bool singular = std::any_of(system.inertia.begin(), system.inertia.end(), is_singular);
  singular ? factor_augmented(system) : factor_blocks(system);
}

void Metric::factor_blocks(const TangentSystem& s) {
  const Eigen::Index nb = static_cast<Eigen::Index>(s.mass.size());
  diagonal_.resize(6 * nb);
  root_mass_.resize(nb);
  for (Eigen::Index b = 0; b < nb; ++b) {
    root_mass_[b] = std::sqrt(s.mass[b]);
    block_factor_.push_back(s.inertia[b].llt().matrixL());
    diagonal_.segment<3>(6 * b).setConstant(s.mass[b]);
    diagonal_.segment<3>(6 * b + 3) = s.inertia[b].diagonal();
  }
}

void Metric::factor_augmented(const TangentSystem& s) {
  const MatrixX<double> M = mass_matrix(s);
  const double phi2 = s.Phi.squaredNorm();
  mu_ = phi2 > 0 ? M.trace() / phi2 : 0.0;
  const MatrixX<double> H = M + mu_ * s.Phi.transpose() * s.Phi;
  diagonal_ = H.diagonal();
  // a direction without mass or rows keeps its zero pivot, to be found below
  const VectorX<double> scale = diagonal_.unaryExpr([](double x) { return x > 0 ? 1 / std::sqrt(x) : 1.0; });
  const MatrixX<double> scaled = scale.asDiagonal() * H * scale.asDiagonal();
  const Eigen::LLT<MatrixX<double>> llt(scaled);
  // a pivot of the equilibrated metric is the square of a distance: below 1e-13 it is rounding
  if (llt.info() != Eigen::Success || llt.matrixLLT().diagonal().minCoeff() < std::sqrt(1e-13))
    throw_without_inertia(s, H, scale);
  dense_factor_ = scale.cwiseInverse().asDiagonal() * MatrixX<double>(llt.matrixL());
}

MatrixX<double> Metric::half_solve(const MatrixX<double>& x) const {
  if (mu_ > 0) return dense_factor_.triangularView<Eigen::Lower>().solve(x);
  MatrixX<double> y = x;
  for (Eigen::Index b = 0; b < root_mass_.size(); ++b) {
    y.middleRows<3>(6 * b) /= root_mass_[b];
    block_factor_[b].triangularView<Eigen::Lower>().solveInPlace(y.middleRows<3>(6 * b + 3));
  }
  return y;
}

MatrixX<double> Metric::half_solve_transposed(const MatrixX<double>& x) const {
  if (mu_ > 0) return dense_factor_.transpose().triangularView<Eigen::Upper>().solve(x);
  MatrixX<double> y = x;
  for (Eigen::Index b = 0; b < root_mass_.size(); ++b) {
    y.middleRows<3>(6 * b) /= root_mass_[b];
    block_factor_[b].transpose().triangularView<Eigen::Upper>().solveInPlace(y.middleRows<3>(6 * b + 3));
  }
  return y;
}

RowAnalysis analyse_rows(const TangentSystem& s) {
  RowAnalysis out;
  const Metric metric(s);
  out.mu = metric.mu();
  out.acceleration_scale = metric.diagonal().cwiseSqrt();
  const VectorX<double> Q_magnitude = s.Q.cwiseAbs();
  const VectorX<double> half_Q = metric.half_solve(s.Q);
  out.acceleration_cause = half_Q.norm();
  if (s.Phi.rows() == 0) {
    out.null_basis.resize(0, 0);
    return out;
  }
  MatrixX<double> W = metric.half_solve(s.Phi.transpose());
  out.E = W.colwise().norm();
  const VectorX<double> E_inverse = inverse_or_zero(out.E);
  // magnitudes throughout: M^-1 |Q| has components of either sign where the metric couples coordinates
  out.lambda_cause =
      s.Phi.cwiseAbs() * metric.half_solve_transposed(metric.half_solve(Q_magnitude)).cwiseAbs() +
      s.gamma.cwiseAbs();
  out.acceleration_cause += E_inverse.cwiseProduct(s.gamma).norm();
  decide_rank(s, out);
  find_contradictions(s, out);

  W = W * E_inverse.asDiagonal();
  const MatrixX<double> S = W.transpose() * W;
  const VectorX<double> singular_values =
      Eigen::SelfAdjointEigenSolver<MatrixX<double>>(S, Eigen::EigenvaluesOnly).eigenvalues();
  const Eigen::Index nc = s.Phi.rows();
  if (out.rank == 0) return out;
  const double largest = singular_values[nc - 1], smallest = singular_values[nc - out.rank];
  out.kappa = largest / std::max(smallest, largest * 1e-16);
  return out;
}

}  // namespace trivium
