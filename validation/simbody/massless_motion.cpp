/// Looks for combinations of massless rotations that the joints with mobilizers do not resist: vectors that
/// the rows of these joints map to nearly 0.

#include "validation/simbody/massless_motion.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/raise.hpp"
#include "bodies/inertia.hpp"

namespace trivium {

namespace {

/// Bound of the eigenvalues of `squares` below, which are squares of angles. A rotation about an axis at an
/// angle theta to the massless axis has theta^2 times the inertia of a transverse rotation. The tolerance of
/// a principal moment, an inertia, is therefore also the bound of theta^2.
constexpr double tolerance = inertia_tolerance;

struct MasslessRotation {
  int body;
  Vector3<double> axis;
};

std::vector<MasslessRotation> massless_rotations(const Mechanism<double>& mechanism) {
  std::vector<MasslessRotation> out;
  for (int b = 0; b < mechanism.nb(); ++b) {
    const Matrix3<double>& J = mechanism.bodies[b].inertia;
    const Eigen::SelfAdjointEigenSolver<Matrix3<double>> principal(J);
    for (int k = 0; k < 3; ++k)
      if (principal.eigenvalues()[k] <= tolerance * J.trace())
        out.push_back({b, principal.eigenvectors().col(k)});
  }
  return out;
}

/// The size of a body [m]: its radius of gyration combined with the largest lever arm of its rows. It makes
/// rotations comparable with displacements.
double size_of(const Mechanism<double>& mechanism, const MatrixX<double>& Phi, int body) {
  double reach = 0;
  for (Eigen::Index row = 0; row < Phi.rows(); ++row) {
    const double r = Phi.block<1, 3>(row, 6 * body).norm();
    if (r > 0) raise(reach, Phi.block<1, 3>(row, 6 * body + 3).norm() / r);
  }
  const auto& [mass, inertia] = mechanism.bodies[static_cast<std::size_t>(body)];
  return std::sqrt(std::max(0.0, inertia.trace()) / mass + reach * reach);
}

}  // namespace

std::optional<std::string> massless_motion(const Mechanism<double>& mechanism, const MatrixX<double>& Phi,
                                           const std::vector<int>& mobilizers) {
  const std::vector<MasslessRotation> Z = massless_rotations(mechanism);
  if (Z.empty()) return std::nullopt;
  const Eigen::Index free = static_cast<Eigen::Index>(Z.size());
  std::vector<double> size(mechanism.bodies.size() + 1, 0.0);  // the ground has size 0
  for (const MasslessRotation& rotation : Z)
    size[static_cast<std::size_t>(rotation.body)] = size_of(mechanism, Phi, rotation.body);

  MatrixX<double> squares =
      MatrixX<double>::Zero(free, free);  // (Phi_t Z)^T Phi_t Z, with dimensionless rows
  for (const int k : mobilizers) {
    const Joint<double>& joint = mechanism.joints[static_cast<std::size_t>(k)];
    const double length =
        std::max(size[static_cast<std::size_t>(joint.i)], size[static_cast<std::size_t>(joint.j)]);
    for (int row = joint.first_row; row < joint.first_row + joint.rows; ++row) {
      VectorX<double> along(free);
      bool holds_a_point = false;
      for (Eigen::Index z = 0; z < free; ++z) {
        const auto& [body, axis] = Z[static_cast<std::size_t>(z)];
        along[z] = Phi.block<1, 3>(row, 6 * body + 3) * axis;
        holds_a_point = holds_a_point || !Phi.block<1, 3>(row, 6 * body).isZero(0);
      }
      if (holds_a_point && length > 0) along /= length;
      squares += along * along.transpose();
    }
  }
  const Eigen::SelfAdjointEigenSolver<MatrixX<double>> motions(squares);
  if (motions.eigenvalues()[0] > tolerance) return std::nullopt;
  Eigen::Index most;
  motions.eigenvectors().col(0).cwiseAbs().maxCoeff(&most);
  const int body = Z[static_cast<std::size_t>(most)].body;
  return mechanism.body_names[static_cast<std::size_t>(body)];
}

}  // namespace trivium
