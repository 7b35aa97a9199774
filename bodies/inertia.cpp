#include "bodies/inertia.hpp"

#include <Eigen/Eigenvalues>

namespace trivium {

InertiaCheck check_inertia(const Eigen::Matrix3d& inertia) {
  InertiaCheck check;
  const double tolerance = inertia_tolerance * std::abs(inertia.trace());
  check.symmetric = (inertia - inertia.transpose()).cwiseAbs().maxCoeff() <= tolerance;
  const Eigen::Matrix3d symmetric_part = 0.5 * (inertia + inertia.transpose());
  check.principal_moments =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(symmetric_part, Eigen::EigenvaluesOnly).eigenvalues();
  const auto& j = check.principal_moments;
  check.positive_semidefinite = j[0] >= -tolerance;
  check.triangle_inequality = j[2] <= j[0] + j[1] + tolerance;
  return check;
}

}  // namespace trivium
