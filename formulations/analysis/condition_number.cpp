/// kappa from the eigenvalues of W^T W, which is the equilibrated Schur complement.

#include "formulations/analysis/condition_number.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace trivium {

double condition_number(const MatrixX<double>& W, int rank) {
  if (rank == 0) return 1;
  const MatrixX<double> S = W.transpose() * W;
  const VectorX<double> singular_values =
      Eigen::SelfAdjointEigenSolver<MatrixX<double>>(S, Eigen::EigenvaluesOnly).eigenvalues();
  const Eigen::Index nc = S.rows();
  const double largest = singular_values[nc - 1], smallest = singular_values[nc - rank];
  return largest / std::max(smallest, largest * 1e-16);
}

}  // namespace trivium
