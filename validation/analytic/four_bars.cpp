/// The problem of the four-bar ladders (declared in problems.hpp).

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>

#include "validation/analytic/problems.hpp"

namespace trivium::analytic {

/// The upright rods of the four-bars all turn by the same angle, and the couplers translate. The angle moves
/// like that of a pendulum that rotates full turns: psi / 2 = am(rate t - K).
void four_bars(const std::string& formulation, Errors& errors) {
  const int loops = 2;
  const double inertia = (loops + 1) / 3.0 + loops, weight = 9.81 * ((loops + 1) / 2.0 + loops),
               a = weight / inertia, k = std::sqrt(4 * a / (1 + 4 * a)), rate = std::sqrt(1 + 4 * a) / 2,
               K = boost::math::ellint_1(k);
  for (const MotionSample& s : motion(catalogue_scene("n_four_bar_2"), formulation, 10, 0.25)) {
    double cn, dn;
    const double sn = boost::math::jacobi_elliptic(k, rate * s.state.t - K, &cn, &dn);
    // psi is the angle from the lowest position; the angle of the rods from the upright position is psi + pi
    const double sin_psi = 2 * sn * cn, cos_psi = 1 - 2 * sn * sn;
    const Vector exact(loops - 0.5 - sin_psi, -cos_psi, 0);
    errors.raise("position [m]", (s.state.pose.back().r - exact).norm(), 1e-6);
  }
}

}  // namespace trivium::analytic
