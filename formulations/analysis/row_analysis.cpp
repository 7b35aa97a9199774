/// A QR factorisation of the transposed, scaled Jacobian with column pivoting gives the rank and the null
/// space. The null space gives the multipliers that are not unique and the choice of the dependent rows. The
/// right sides of these rows are then compared with the values that the independent rows imply.

#include "formulations/analysis/row_analysis.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.hpp"
#include "formulations/analysis/condition_number.hpp"
#include "formulations/analysis/row_analysis_impl.hpp"

namespace trivium {

namespace {

/// The connected component of each body. Rows connect bodies, but not through the ground.
std::vector<Eigen::Index> connected_components(const TangentSystem& s) {
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

/// Column scales that measure rotations in metres: a rotation column is divided by the root mean square of
/// |Phi_pi_bar| / |Phi_r| [m] over the rows with a translational part in the same component.
VectorX<double> geometric_column_scale(const TangentSystem& s) {
  const Eigen::Index nb = static_cast<Eigen::Index>(s.mass.size());
  const std::vector<Eigen::Index> component = connected_components(s);
  VectorX<double> translation = VectorX<double>::Zero(nb), rotation = translation;  // sums per component
  for (Eigen::Index k = 0; k < s.Phi.rows(); ++k) {
    double r2 = 0, rot2 = 0;
    Eigen::Index in = 0;
    for (Eigen::Index b = 0; b < nb; ++b) {
      const auto row = s.Phi.block<1, 6>(k, 6 * b);
      if (row.isZero(0)) continue;
      r2 += row.head<3>().squaredNorm();
      rot2 += row.tail<3>().squaredNorm();
      in = component[b];
    }
    if (r2 == 0) continue;
    translation[in] += 1;
    rotation[in] += rot2 / r2;
  }
  VectorX<double> scale = VectorX<double>::Ones(s.Phi.cols());
  for (Eigen::Index b = 0; b < nb; ++b)
    if (const Eigen::Index a = component[b]; rotation[a] > 0)
      scale.segment<3>(6 * b + 3).setConstant(std::sqrt(translation[a] / rotation[a]));
  return scale;
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

/// Chooses the dependent rows from the null basis Z: as far as possible the last rows of the file, such that
/// their rows of Z stay well conditioned. The remainder of a row of Z, orthogonal to the rows already chosen,
/// must exceed a share of the row's norm (null_space_share). Its norm must also exceed a tenth of this
/// share, because a row of small norm makes the chosen rows badly conditioned even if it is orthogonal to
/// them. The norms are at most 1, since Z has orthonormal columns. The tenth is chosen by experiment: a
/// smaller factor costs digits of the multipliers, a larger one passes over more of the last rows.
std::vector<int> choose_dependent(const MatrixX<double>& Z) {
  const Eigen::Index d = Z.cols();
  // half of the least share: the divisions round
  for (double threshold = null_space_share; threshold > least_null_space_share / 2; threshold /= 10) {
    std::vector<int> chosen;
    MatrixX<double> basis(d, 0);
    for (Eigen::Index k = Z.rows() - 1; k >= 0 && static_cast<Eigen::Index>(chosen.size()) < d; --k) {
      VectorX<double> rest = Z.row(k).transpose();
      // the second pass removes the rounding errors of the first
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
  }
  throw ModelError("could not choose the dependent rows: the null space of Phi_q^T is too badly conditioned");
}

void decide_rank(const ScaledJacobian& scaled, double rank_tolerance, RowAnalysis& out) {
  const int nc = static_cast<int>(scaled.Phi.rows());
  const VectorX<double>& row_scale = scaled.rows;
  out.unique.assign(nc, true);
  Eigen::ColPivHouseholderQR<MatrixX<double>> qr;
  qr.setThreshold(rank_tolerance);
  qr.compute(scaled.Phi.transpose());
  const int rank = static_cast<int>(qr.rank()), defect = nc - rank;
  out.rank = rank;
  // two decades: the verdict on a share this close can change if the points of the row gain or lose two
  // digits
  constexpr double margin = 100;
  for (int k = 0; k < std::min<int>(nc, static_cast<int>(scaled.Phi.cols())); ++k) {
    const double share = std::abs(qr.matrixR()(k, k)) / qr.maxPivot();
    if (share > rank_tolerance / margin && share < rank_tolerance * margin)
      out.narrow.push_back({static_cast<int>(qr.colsPermutation().indices()[k]), share, rank_tolerance});
  }

  // a row without a gradient constrains nothing: it is dependent and has no column in the null basis
  std::vector<Eigen::Index> dependent;
  for (int d = 0; d < defect; ++d) {
    const int k = qr.colsPermutation().indices()[rank + d];
    if (row_scale[k] > 0)
      dependent.push_back(d);
    else
      out.unique[k] = false;
  }
  const Eigen::Index null = static_cast<Eigen::Index>(dependent.size());
  MatrixX<double> Z(nc, null);  // null space of the transposed scaled Jacobian
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
    out.dependent = choose_dependent(Z);
  }
  for (int k = 0; k < nc; ++k)
    if (row_scale[k] == 0) out.dependent.push_back(k);
  std::sort(out.dependent.begin(), out.dependent.end());
  for (int k = 0; k < nc; ++k)
    if (!std::binary_search(out.dependent.begin(), out.dependent.end(), k)) out.independent.push_back(k);

  // From the null basis Z of the scaled rows follows a null basis N of the rows themselves, chosen such that
  // E N has orthonormal columns.
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

/// RowAnalysis::combination: pseudo-inverse of the transposed independent rows in geometric scaling.
MatrixX<double> combination_of(const ScaledJacobian& scaled, const std::vector<int>& independent) {
  const Eigen::Index rank = static_cast<Eigen::Index>(independent.size()), columns = scaled.Phi.cols();
  const MatrixX<double> rows = scaled.Phi(independent, Eigen::all);
  const Eigen::HouseholderQR<MatrixX<double>> qr(rows.transpose());
  const MatrixX<double> Q = qr.householderQ() * MatrixX<double>::Identity(columns, rank);
  const MatrixX<double> R = qr.matrixQR().topRows(rank);
  return scaled.rows(independent).asDiagonal() * R.triangularView<Eigen::Upper>().solve(Q.transpose()) *
         scaled.columns.asDiagonal();
}

/// Compares gamma of each dependent row with the value that the independent rows imply.
void find_contradictions(const TangentSystem& s, const ScaledJacobian& scaled, RowAnalysis& out) {
  const VectorX<double>&columns = scaled.columns, &row_scale = scaled.rows;
  const VectorX<double> gamma = (row_scale.array() > 0).select(row_scale, 1.0).cwiseProduct(s.gamma);
  // the minimum-norm acceleration that satisfies the independent rows gives the implied values
  const VectorX<double> acceleration = out.combination.transpose() * s.gamma(out.independent);
  const double largest = std::max(gamma.cwiseAbs().maxCoeff(), acceleration.cwiseQuotient(columns).norm());
  // The terms of gamma cancel where a body spins about an axis through the points of its joints: gamma is
  // then rounding of these terms. 100 roundings are a safety factor.
  constexpr double rounding = 100 * std::numeric_limits<double>::epsilon();
  const VectorX<double>& sizes = s.magnitudes.gamma;
  const double uncancelled = sizes.size() > 0 ? row_scale.cwiseProduct(sizes).maxCoeff() : 0.0;
  for (int k : out.dependent)
    if (std::abs(row_scale[k] * s.Phi.row(k).dot(acceleration) - gamma[k]) >
        contradiction_tolerance_at(s.rank_tolerance) * largest + rounding * uncancelled + contradiction_floor)
      out.contradictory.push_back(k);
}

}  // namespace

RowAnalysis analyse_rows(const TangentSystem& s) {
  const MassMetric metric(s);
  RowAnalysis out;
  const MatrixX<double> W = metric.half_solve(s.Phi.transpose());
  static_cast<RowNorms&>(out) = row_norms(s, metric, W);
  if (s.Phi.rows() == 0) {
    out.null_basis.resize(0, 0);
    return out;
  }
  const ScaledJacobian scaled(s);
  decide_rank(scaled, s.rank_tolerance, out);
  if (!out.dependent.empty()) {
    out.combination = combination_of(scaled, out.independent);
    find_contradictions(s, scaled, out);
  }
  out.kappa = condition_number(W * inverse_or_zero(out.E).asDiagonal(), out.rank);
  return out;
}

std::vector<std::string> narrow_row_warnings(const std::vector<std::string>& row_names,
                                             const RowAnalysis& rows, double least_tolerance) {
  std::vector<std::string> out;
  for (const NarrowRow& narrow : rows.narrow) {
    const bool counts = narrow.counts();
    std::string advice =
        counts ? "if it should follow from the others, give its points and axes more digits"
               : "if it should hold, move its points and axes farther from those of the other rows";
    if (counts || narrow.share > least_tolerance)
      advice +=
          fmt::format(", or set the rank tolerance {} {:.1e}", counts ? "above" : "below", narrow.share);
    out.push_back(fmt::format(
        "row \"{}\" {} by a narrow margin: {:.1e} of its gradient is independent of the other rows, and the "
        "limit is {:.0e}; {}",
        row_names[narrow.row], counts ? "counts as independent" : "is left out", narrow.share,
        narrow.tolerance, advice));
  }
  return out;
}

FreeMotion free_motion(const TangentSystem& s, int row) {
  const VectorX<double> columns = geometric_column_scale(s);
  MatrixX<double> others = columns.asDiagonal() * s.Phi.transpose();
  VectorX<double> gradient = others.col(row);
  others.col(row).setZero();
  Eigen::ColPivHouseholderQR<MatrixX<double>> qr;
  qr.setThreshold(s.rank_tolerance);
  qr.compute(others);
  gradient = qr.householderQ().transpose() * gradient;
  gradient.head(qr.rank()).setZero();
  FreeMotion motion{gradient.norm(), VectorX<double>::Zero(gradient.size())};
  if (motion.gradient > 0)
    motion.q_dot = columns.asDiagonal() * (qr.householderQ() * gradient) / motion.gradient;
  return motion;
}

double free_curvature(const TangentSystem& s, int row, const VectorX<double>& gamma) {
  const VectorX<double> columns = geometric_column_scale(s);
  MatrixX<double> others = s.Phi * columns.asDiagonal();
  others.row(row).setZero();
  VectorX<double> right = gamma;
  right[row] = 0;
  Eigen::CompleteOrthogonalDecomposition<MatrixX<double>> held;
  held.setThreshold(s.rank_tolerance);
  const VectorX<double> q_ddot = columns.asDiagonal() * held.compute(others).solve(right);
  return s.Phi.row(row).dot(q_ddot) - gamma[row];
}

template RowAnalysis analyse_rows<StandardTypes>(const Model<double>&);

}  // namespace trivium
