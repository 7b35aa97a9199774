/// A regular M is factored body by body. A singular M is augmented by the weighted rows, scaled along the
/// principal axes of the bodies and factored as a whole, which also finds motions without inertia and rows.

#include "formulations/analysis/mass_metric.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "bodies/inertia.hpp"

namespace trivium {

namespace {

bool is_singular(const Matrix3<double>& J) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(J, Eigen::EigenvaluesOnly).eigenvalues()[0] <=
         inertia_tolerance * J.trace();
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

/// The weights mu of MassMetric.
VectorX<double> row_weights(const TangentSystem& s) {
  VectorX<double> mu = VectorX<double>::Zero(s.Phi.rows());
  for (Eigen::Index k = 0; k < s.Phi.rows(); ++k) {
    double least = std::numeric_limits<double>::infinity();
    // for a row that acts only on rotations of bodies without any moment of inertia: mass times 1 m^2 is
    // taken for the moment
    double fallback = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < s.mass.size(); ++b) {
      const Eigen::Index at = 6 * static_cast<Eigen::Index>(b);
      const double r2 = s.Phi.block<1, 3>(k, at).squaredNorm();
      const double rot2 = s.Phi.block<1, 3>(k, at + 3).squaredNorm();
      const double J = s.inertia[b].trace();
      if (r2 > 0) least = std::min(least, s.mass[b] / r2);
      if (rot2 > 0 && J > 0) least = std::min(least, J / rot2);
      if (rot2 > 0) fallback = std::min(fallback, s.mass[b] / rot2);
    }
    if (!std::isfinite(least)) least = fallback;
    if (std::isfinite(least)) mu[k] = std::exp2(std::round(std::log2(least)));
  }
  return mu;
}

VectorX<double> least_direction(const MatrixX<double>& H) {
  return Eigen::SelfAdjointEigenSolver<MatrixX<double>>(H).eigenvectors().col(0);
}

/// Throws for a singular metric. The error names the body that rotates most in the direction without mass and
/// rows.
[[noreturn]] void throw_without_inertia(const TangentSystem& s, const VectorX<double>& direction) {
  Eigen::Index worst = 0;
  double size = -1;
  for (Eigen::Index b = 0; b < static_cast<Eigen::Index>(s.mass.size()); ++b)
    if (const double turn = direction.segment<3>(6 * b + 3).norm(); turn > size) {
      size = turn;
      worst = b;
    }
  const Vector3<double> axis = direction.segment<3>(6 * worst + 3).normalized().unaryExpr([](double x) {
    // The components of an eigenvector have rounding errors of about 1e-16, or more if eigenvalues are close.
    // The value only keeps them out of the message: a larger one would round the axis visibly.
    constexpr double rounding_of_eigenvectors = 1e-9;
    return std::abs(x) < rounding_of_eigenvectors ? 0.0 : x;
  });
  throw ModelError(
      {fmt::format("body \"{}\"", s.body_names[worst])},
      fmt::format("the body has no inertia about its axis ({:.3g}, {:.3g}, {:.3g}), and no constraint "
                  "prevents rotation about it, so the angular acceleration is undetermined; give the body "
                  "inertia about this axis, or constrain the rotation",
                  axis[0], axis[1], axis[2]));
}

}  // namespace

MassMetric::MassMetric(const TangentSystem& system) {
  const bool singular = std::any_of(system.inertia.begin(), system.inertia.end(), is_singular);
  singular ? factor_augmented(system) : factor_blocks(system);
}

void MassMetric::factor_blocks(const TangentSystem& s) {
  const Eigen::Index nb = static_cast<Eigen::Index>(s.mass.size());
  diagonal_.resize(6 * nb);
  root_mass_.resize(nb);
  mu_ = VectorX<double>::Zero(s.Phi.rows());
  for (Eigen::Index b = 0; b < nb; ++b) {
    root_mass_[b] = std::sqrt(s.mass[b]);
    block_factor_.push_back(s.inertia[b].llt().matrixL());
    diagonal_.segment<3>(6 * b).setConstant(s.mass[b]);
    diagonal_.segment<3>(6 * b + 3) = s.inertia[b].diagonal();
  }
}

void MassMetric::factor_augmented(const TangentSystem& s) {
  const Eigen::Index nb = static_cast<Eigen::Index>(s.mass.size());
  mu_ = row_weights(s);
  const MatrixX<double> H = mass_matrix(s) + s.Phi.transpose() * mu_.asDiagonal() * s.Phi;
  diagonal_ = H.diagonal();
  // principal axes: the diagonal scaling below can equilibrate a direction without inertia only if this
  // direction is a coordinate axis
  MatrixX<double> axes = MatrixX<double>::Identity(6 * nb, 6 * nb);
  for (Eigen::Index b = 0; b < nb; ++b)
    axes.block<3, 3>(6 * b + 3, 6 * b + 3) =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(s.inertia[b]).eigenvectors();
  const MatrixX<double> Phi = s.Phi * axes;
  MatrixX<double> principal = Phi.transpose() * mu_.asDiagonal() * Phi;
  for (Eigen::Index b = 0; b < nb; ++b) {
    principal.block<3, 3>(6 * b, 6 * b).diagonal().array() += s.mass[b];
    const Vector3<double> moments = (axes.block<3, 3>(6 * b + 3, 6 * b + 3).transpose() * s.inertia[b] *
                                     axes.block<3, 3>(6 * b + 3, 6 * b + 3))
                                        .diagonal();
    // a principal moment within the rounding error of the tensor is taken as zero
    for (int n = 0; n < 3; ++n)
      if (moments[n] > inertia_tolerance * moments.sum())
        principal(6 * b + 3 + n, 6 * b + 3 + n) += moments[n];
  }
  // a direction without mass and rows keeps its zero pivot, which the factorisation below detects
  const VectorX<double> scale =
      principal.diagonal().unaryExpr([](double x) { return x > 0 ? 1 / std::sqrt(x) : 1.0; });
  const MatrixX<double> scaled = scale.asDiagonal() * principal * scale.asDiagonal();
  const Eigen::LLT<MatrixX<double>> llt(scaled);
  // The equilibrated metric is R^T R with columns of unit size in R. A pivot is the squared distance of a
  // column from the span of the columns before. Its rounding error is some u times the number of columns. A
  // pivot below 1e-13 is such an error.
  constexpr double least_pivot = 1e-13;
  if (llt.info() != Eigen::Success || llt.matrixLLT().diagonal().minCoeff() < std::sqrt(least_pivot))
    throw_without_inertia(s, axes * scale.cwiseProduct(least_direction(scaled)));
  axes_ = std::move(axes);
  dense_factor_ = scale.cwiseInverse().asDiagonal() * MatrixX<double>(llt.matrixL());
}

MatrixX<double> MassMetric::half_solve(const MatrixX<double>& x) const {
  if (axes_.size() > 0) return dense_factor_.triangularView<Eigen::Lower>().solve(axes_.transpose() * x);
  MatrixX<double> y = x;
  for (Eigen::Index b = 0; b < root_mass_.size(); ++b) {
    y.middleRows<3>(6 * b) /= root_mass_[b];
    block_factor_[b].triangularView<Eigen::Lower>().solveInPlace(y.middleRows<3>(6 * b + 3));
  }
  return y;
}

MatrixX<double> MassMetric::half_solve_transposed(const MatrixX<double>& x) const {
  if (axes_.size() > 0) return axes_ * dense_factor_.transpose().triangularView<Eigen::Upper>().solve(x);
  MatrixX<double> y = x;
  for (Eigen::Index b = 0; b < root_mass_.size(); ++b) {
    y.middleRows<3>(6 * b) /= root_mass_[b];
    block_factor_[b].transpose().triangularView<Eigen::Upper>().solveInPlace(y.middleRows<3>(6 * b + 3));
  }
  return y;
}

}  // namespace trivium
