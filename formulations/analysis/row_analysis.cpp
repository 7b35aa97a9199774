#include "formulations/analysis/row_analysis.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "formulations/analysis/magnitude_bounds.hpp"

namespace trivium {

namespace {

/// A principal moment below this share of the trace is none: the tolerance of the scene format.
constexpr double singular_moment = 1e-12;

bool is_singular(const Matrix3<double>& J) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(J, Eigen::EigenvaluesOnly).eigenvalues()[0] <=
         singular_moment * J.trace();
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

/// mu, see Metric.
VectorX<double> row_weights(const TangentSystem& s) {
  VectorX<double> mu = VectorX<double>::Zero(s.Phi.rows());
  for (Eigen::Index k = 0; k < s.Phi.rows(); ++k) {
    double least = std::numeric_limits<double>::infinity();
    // a row between bodies without any inertia weighs rotations as if over a metre
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

/// Where the metric cannot be factored: the body that moves most in the direction without mass or constraint.
[[noreturn]] void throw_without_inertia(const TangentSystem& s, const VectorX<double>& direction) {
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

/// Bodies that rows connect, not through the ground: each gets the number of its assembly.
std::vector<Eigen::Index> assemblies(const TangentSystem& s) {
  const Eigen::Index nb = static_cast<Eigen::Index>(s.mass.size());
  std::vector<Eigen::Index> of(s.mass.size());
  std::iota(of.begin(), of.end(), Eigen::Index(0));
  const auto find = [&](Eigen::Index b) {
    while (of[b] != b) b = of[b] = of[of[b]];
    return b;
  };
  for (Eigen::Index k = 0; k < s.Phi.rows(); ++k) {
    Eigen::Index first = -1;
    for (Eigen::Index b = 0; b < nb; ++b)
      if (!s.Phi.block<1, 6>(k, 6 * b).isZero(0))
        first < 0 ? void(first = find(b)) : void(of[find(b)] = first);
  }
  for (Eigen::Index b = 0; b < nb; ++b) of[b] = find(b);
  return of;
}

/// Rotations in metres: a rotation column is divided by the lever with which the rows that hold points of the
/// same assembly see rotations.
VectorX<double> geometric_column_scale(const TangentSystem& s) {
  const Eigen::Index nb = static_cast<Eigen::Index>(s.mass.size());
  const std::vector<Eigen::Index> assembly = assemblies(s);
  VectorX<double> translation = VectorX<double>::Zero(nb), rotation = translation;  // sums, per assembly
  for (Eigen::Index k = 0; k < s.Phi.rows(); ++k) {
    double r2 = 0, rot2 = 0;
    Eigen::Index in = 0;
    for (Eigen::Index b = 0; b < nb; ++b) {
      const auto row = s.Phi.block<1, 6>(k, 6 * b);
      if (row.isZero(0)) continue;
      r2 += row.head<3>().squaredNorm();
      rot2 += row.tail<3>().squaredNorm();
      in = assembly[b];
    }
    if (r2 == 0) continue;
    translation[in] += 1;
    rotation[in] += rot2 / r2;
  }
  VectorX<double> scale = VectorX<double>::Ones(s.Phi.cols());
  for (Eigen::Index b = 0; b < nb; ++b)
    if (const Eigen::Index a = assembly[b]; rotation[a] > 0)
      scale.segment<3>(6 * b + 3).setConstant(std::sqrt(translation[a] / rotation[a]));
  return scale;
}

VectorX<double> inverse_or_zero(const VectorX<double>& v) {
  return v.unaryExpr([](double x) { return x > 0 ? 1 / x : 0.0; });
}

/// The Jacobian with rotations in metres and rows of unit size; a row without a gradient has scale 0.
struct ScaledJacobian {
  VectorX<double> columns, rows;  ///< the scales
  MatrixX<double> Phi;

  explicit ScaledJacobian(const TangentSystem& s)
      : columns(geometric_column_scale(s)), Phi(s.Phi * columns.asDiagonal()) {
    rows = inverse_or_zero(Phi.rowwise().norm());
    Phi = rows.asDiagonal() * Phi;
  }
};

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

void decide_rank(const ScaledJacobian& scaled, RowAnalysis& out) {
  const int nc = static_cast<int>(scaled.Phi.rows());
  const VectorX<double>& row_scale = scaled.rows;
  out.unique.assign(nc, true);
  Eigen::ColPivHouseholderQR<MatrixX<double>> qr;
  qr.setThreshold(rank_tolerance);
  qr.compute(scaled.Phi.transpose());
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

/// The least-squares inverse of the independent rows' transpose, in geometric scaling.
MatrixX<double> combination_of(const ScaledJacobian& scaled, const std::vector<int>& independent) {
  const Eigen::Index rank = static_cast<Eigen::Index>(independent.size()), columns = scaled.Phi.cols();
  const MatrixX<double> rows = scaled.Phi(independent, Eigen::all);
  const Eigen::HouseholderQR<MatrixX<double>> qr(rows.transpose());
  const MatrixX<double> Q = qr.householderQ() * MatrixX<double>::Identity(columns, rank);
  const MatrixX<double> R = qr.matrixQR().topRows(rank);
  return scaled.rows(independent).asDiagonal() * R.triangularView<Eigen::Upper>().solve(Q.transpose()) *
         scaled.columns.asDiagonal();
}

/// Redundant rows: gamma_k against what the independent rows make of it.
void find_contradictions(const TangentSystem& s, const ScaledJacobian& scaled, RowAnalysis& out) {
  const VectorX<double>&columns = scaled.columns, &row_scale = scaled.rows;
  const VectorX<double> gamma = (row_scale.array() > 0).select(row_scale, 1.0).cwiseProduct(s.gamma);
  // the least acceleration that meets the independent rows shows what they make of the others
  const VectorX<double> acceleration = out.combination.transpose() * s.gamma(out.independent);
  const double largest = std::max(gamma.cwiseAbs().maxCoeff(), acceleration.cwiseQuotient(columns).norm());
  for (int k : out.redundant)
    if (std::abs(row_scale[k] * s.Phi.row(k).dot(acceleration) - gamma[k]) >
        contradiction_tolerance * largest + contradiction_floor)
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
  mu_ = VectorX<double>::Zero(s.Phi.rows());
  for (Eigen::Index b = 0; b < nb; ++b) {
    root_mass_[b] = std::sqrt(s.mass[b]);
    block_factor_.push_back(s.inertia[b].llt().matrixL());
    diagonal_.segment<3>(6 * b).setConstant(s.mass[b]);
    diagonal_.segment<3>(6 * b + 3) = s.inertia[b].diagonal();
  }
}

void Metric::factor_augmented(const TangentSystem& s) {
  const Eigen::Index nb = static_cast<Eigen::Index>(s.mass.size());
  mu_ = row_weights(s);
  const MatrixX<double> H = mass_matrix(s) + s.Phi.transpose() * mu_.asDiagonal() * s.Phi;
  diagonal_ = H.diagonal();
  // an axis without inertia must be a coordinate axis for the scaling to reach it: principal axes
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
    // a moment within the rounding of the tensor is none
    for (int n = 0; n < 3; ++n)
      if (moments[n] > singular_moment * moments.sum()) principal(6 * b + 3 + n, 6 * b + 3 + n) += moments[n];
  }
  // a direction without mass or rows keeps its zero pivot, to be found below
  const VectorX<double> scale =
      principal.diagonal().unaryExpr([](double x) { return x > 0 ? 1 / std::sqrt(x) : 1.0; });
  const MatrixX<double> scaled = scale.asDiagonal() * principal * scale.asDiagonal();
  const Eigen::LLT<MatrixX<double>> llt(scaled);
  // a pivot of the equilibrated metric is the square of a distance: below 1e-13 it is rounding
  if (llt.info() != Eigen::Success || llt.matrixLLT().diagonal().minCoeff() < std::sqrt(1e-13))
    throw_without_inertia(s, axes * scale.cwiseProduct(least_direction(scaled)));
  axes_ = std::move(axes);
  dense_factor_ = scale.cwiseInverse().asDiagonal() * MatrixX<double>(llt.matrixL());
}

MatrixX<double> Metric::half_solve(const MatrixX<double>& x) const {
  if (axes_.size() > 0) return dense_factor_.triangularView<Eigen::Lower>().solve(axes_.transpose() * x);
  MatrixX<double> y = x;
  for (Eigen::Index b = 0; b < root_mass_.size(); ++b) {
    y.middleRows<3>(6 * b) /= root_mass_[b];
    block_factor_[b].triangularView<Eigen::Lower>().solveInPlace(y.middleRows<3>(6 * b + 3));
  }
  return y;
}

MatrixX<double> Metric::half_solve_transposed(const MatrixX<double>& x) const {
  if (axes_.size() > 0) return axes_ * dense_factor_.transpose().triangularView<Eigen::Upper>().solve(x);
  MatrixX<double> y = x;
  for (Eigen::Index b = 0; b < root_mass_.size(); ++b) {
    y.middleRows<3>(6 * b) /= root_mass_[b];
    block_factor_[b].transpose().triangularView<Eigen::Upper>().solveInPlace(y.middleRows<3>(6 * b + 3));
  }
  return y;
}

namespace {

/// |Phi| M^-1 |Q| + |gamma| in which nothing cancels.
VectorX<double> size_uncancelled(const Magnitudes& sizes, const Metric& metric) {
  const VectorX<double> reach = metric.half_solve_transposed(metric.half_solve(sizes.Q));
  VectorX<double> cause = sizes.gamma;
  for (Eigen::Index k = 0; k < cause.size(); ++k) {
    const auto& [bodies, r, rot_i, rot_j] = sizes.rows[k];
    for (const auto& [b, rot] : {std::pair{bodies.i, rot_i}, {bodies.j, rot_j}})
      if (6 * b < reach.size())
        cause[k] += r * reach.segment<3>(6 * b).norm() + rot * reach.segment<3>(6 * b + 3).norm();
  }
  return cause;
}

}  // namespace

RowAnalysis analyse_rows(const TangentSystem& s) {
  RowAnalysis out;
  const Metric metric(s);
  out.mu = metric.mu();
  out.acceleration_scale = metric.diagonal().cwiseSqrt();
  out.acceleration_bound = metric.half_solve(s.Q).norm();
  const Magnitudes& sizes = s.magnitudes;
  const bool by_magnitude = sizes.Q.size() > 0;
  double acceleration_by_magnitude = by_magnitude ? metric.half_solve(sizes.Q).norm() : 0.0;
  if (s.Phi.rows() == 0) {
    out.acceleration_bound = std::max(out.acceleration_bound, cancellation_floor * acceleration_by_magnitude);
    out.null_basis.resize(0, 0);
    return out;
  }
  MatrixX<double> W = metric.half_solve(s.Phi.transpose());
  out.E = W.colwise().norm();
  const VectorX<double> E_inverse = inverse_or_zero(out.E);
  // magnitudes throughout: M^-1 |Q| has components of either sign where the metric couples coordinates
  out.schur_rhs_bound =
      s.Phi.cwiseAbs() * metric.half_solve_transposed(metric.half_solve(s.Q.cwiseAbs())).cwiseAbs() +
      s.gamma.cwiseAbs();
  out.acceleration_bound += E_inverse.cwiseProduct(s.gamma).norm();
  if (by_magnitude) {
    out.schur_rhs_bound_uncancelled = size_uncancelled(sizes, metric);
    out.schur_rhs_bound = out.schur_rhs_bound.cwiseMax(cancellation_floor * out.schur_rhs_bound_uncancelled);
    acceleration_by_magnitude += E_inverse.cwiseProduct(sizes.gamma).norm();
  }
  out.acceleration_bound = std::max(out.acceleration_bound, cancellation_floor * acceleration_by_magnitude);
  const ScaledJacobian scaled(s);
  decide_rank(scaled, out);
  if (!out.redundant.empty()) {
    out.combination = combination_of(scaled, out.independent);
    find_contradictions(s, scaled, out);
  }

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

namespace {

std::string contradiction(const Mechanism<double>& mechanism, const RowAnalysis& rows) {
  std::string names;
  for (int k : rows.contradictory) names += (names.empty() ? "" : ", ") + mechanism.row_names[k];
  return fmt::format(
      "no acceleration satisfies all rows: {} against the rows before; remove a row, or make their "
      "functions of time agree",
      names);
}

}  // namespace

RowAnalysis analyse_rows(const Model<double>& model) {
  const auto& [mechanism, state] = model;
  const int unknowns = 6 * mechanism.nb() + mechanism.nc();
  if (unknowns > most_dense_unknowns)
    throw ModelError(
        fmt::format("{}: {} bodies and {} rows make a dense augmented matrix of {} unknowns, beyond the {} "
                    "that the printed form is "
                    "solved for; take fewer bodies",
                    mechanism.name, mechanism.nb(), mechanism.nc(), unknowns, most_dense_unknowns));
  try {
    TangentSystem system = tangent_system(mechanism, state);
    add_magnitude_bounds(mechanism, state, system);
    RowAnalysis rows = analyse_rows(system);
    if (!rows.contradictory.empty()) throw ModelError(contradiction(mechanism, rows));
    return rows;
  } catch (const ModelError& error) {
    throw ModelError(fmt::format("{} at t = {}: {}", mechanism.name, state.t, error.what()));
  }
}

}  // namespace trivium
