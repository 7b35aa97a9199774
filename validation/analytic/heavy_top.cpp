/// Heavy symmetric tops: nutation and steady precession (declared in problems.hpp).

#include <cmath>

#include "validation/analytic/problems.hpp"

namespace trivium::analytic {

void heavy_top(const std::string& formulation, Errors& errors) {
  // The period of nutation [s] is 4 K(k) / sqrt(2 m g l (u_3 - u_1) / A), with the moment A about the tip,
  // the roots u_1 < u_2 < u_3 of Lagrange's cubic for the cosine u of the inclination, and k^2 = (u_2 - u_1)
  // / (u_3 - u_1).
  constexpr double period = 0.74520694761676905573;
  const scenes::Scene scene = catalogue_scene("heavy_top");
  for (const double t : {0.1, 0.2, 0.3}) {
    const MotionSample first = motion(scene, formulation, t, t).back(),
                       again = motion(scene, formulation, t + period, t + period).back();
    errors.raise("height after a nutation [m]", std::abs(first.state.pose[0].r[2] - again.state.pose[0].r[2]),
                 1e-9);
    errors.raise("spin [rad/s]", std::abs(again.state.twist[0].omega_bar[1] - 150), 1e-9);
  }
}

void steady_precession(const std::string& formulation, Errors& errors) {
  scenes::Scene scene = catalogue_scene("heavy_top");
  const double n = 150, Omega = 15 * 9.81 / (0.46875 * n);
  scene.bodies[0].angular_velocity = {0, n, Omega};
  scene.bodies[0].velocity = {-Omega, 0, 0};
  for (const MotionSample& s : motion(scene, formulation, 2, 0.1)) {
    const double phi = Omega * s.state.t;
    const Vector r(-std::sin(phi), std::cos(phi), 0);
    errors.raise("position [m]", (s.state.pose[0].r - r).norm(), 1e-9);
    errors.raise("reaction [N]",
                 (s.reactions[0].force - 15 * (Vector(0, 0, 9.81) - Omega * Omega * r)).norm(), 1e-5);
  }
}

}  // namespace trivium::analytic
