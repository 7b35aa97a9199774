/// Pendulums, whose angle has a closed form (declared in problems.hpp).

#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>

#include "validation/analytic/problems.hpp"

namespace trivium::analytic {

namespace {

/// The angle [rad] from the vertical of a pendulum released from rest at the horizontal: sin(theta / 2) = k
/// cd(omega t) with k^2 = 1/2.
double released_angle(double omega, double t) {
  const double k = std::sqrt(0.5);
  double cn, dn;
  boost::math::jacobi_elliptic(k, omega * t, &cn, &dn);
  return 2 * std::asin(k * cn / dn);
}

}  // namespace

void pendulum(const std::string& formulation, Errors& errors) {
  const double g = 9.81;
  for (const MotionSample& s : motion(catalogue_scene("a01_pendulum"), formulation, 10, 0.1)) {
    const double theta = released_angle(std::sqrt(g), s.state.t);
    const Vector exact(-std::sin(theta), -std::cos(theta), 0);
    errors.raise("position [m]", (s.state.pose[0].r - exact).norm(), 1e-10);
    errors.raise("tension [N]", std::abs(s.reactions[0].force.norm() - 3 * g * std::cos(theta)), 1e-8);
  }
}

void physical_pendulum(const std::string& name, const Vector& side, const std::string& formulation,
                       Errors& errors) {
  const double m = 1, l = 2, J = 0.1, g = 9.80665, omega2 = m * g * l / (J + m * l * l);
  const Vector up(0, 0, 1);
  for (const MotionSample& s : motion(catalogue_scene(name), formulation, 5, 0.1)) {
    const double theta = released_angle(std::sqrt(omega2), s.state.t);
    const Vector out = std::sin(theta) * side - std::cos(theta) * up,
                 along = std::cos(theta) * side + std::sin(theta) * up;
    // theta'^2 = 2 omega^2 cos(theta), theta'' = -omega^2 sin(theta)
    const Vector a = l * (-omega2 * std::sin(theta) * along - 2 * omega2 * std::cos(theta) * out);
    errors.raise("position [m]", (s.state.pose[0].r - l * out).norm(), 1e-10);
    errors.raise("reaction [N]", (s.reactions[0].force - m * (a + g * up)).norm(), 1e-8);
  }
}

}  // namespace trivium::analytic
