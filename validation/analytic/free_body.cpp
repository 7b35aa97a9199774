/// Free bodies, whose angular velocity has a closed form (declared in problems.hpp).

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <utility>
#include <variant>

#include "validation/analytic/problems.hpp"

namespace trivium::analytic {

namespace {

Vector vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

}  // namespace

/// Euler's equations without moments: omega_bar = (s1 a1 cn, s2 a2 sn, s3 a3 dn) with argument p t + u0
/// (Landau and Lifshitz, Mechanics, paragraph 37). This form holds for L^2 >= 2 T J_2; otherwise axes 1 and 3
/// are exchanged.
void free_body(const std::string& name, const std::string& formulation, Errors& errors) {
  const scenes::Scene scene = catalogue_scene(name);
  const auto& diagonal = std::get<scenes::Vector3>(scene.bodies[0].inertia);
  Vector J = vector(diagonal), w = vector(scene.bodies[0].angular_velocity);
  const double twice_T = w.dot(J.cwiseProduct(w)), L2 = J.cwiseProduct(w).squaredNorm();
  const bool is_other = L2 < twice_T * J[1];
  if (is_other) {
    std::swap(J[0], J[2]);
    std::swap(w[0], w[2]);
  }
  const double sign = is_other ? -1 : 1;  // sign of the differences of moments, which the exchange reverses
  const double a1 = std::sqrt((twice_T * J[2] - L2) / (J[0] * (J[2] - J[0]))),
               a2 = std::sqrt((twice_T * J[2] - L2) / (J[1] * (J[2] - J[1]))),
               a3 = std::sqrt((L2 - twice_T * J[0]) / (J[2] * (J[2] - J[0]))),
               p = std::sqrt((J[2] - J[1]) * (L2 - twice_T * J[0]) / (J[0] * J[1] * J[2])),
               k = std::sqrt((J[1] - J[0]) * (twice_T * J[2] - L2) / ((J[2] - J[1]) * (L2 - twice_T * J[0])));
  const double s3 = w[2] < 0 ? -1 : 1, s2 = 1, s1 = sign * s2 * s3;
  const double u0 = boost::math::ellint_1(k, std::atan2(s2 * w[1] / a2, s1 * w[0] / a1));
  for (const MotionSample& s : motion(scene, formulation, 20, 0.25)) {
    double cn, dn;
    const double sn = boost::math::jacobi_elliptic(k, p * s.state.t + u0, &cn, &dn);
    Vector exact(s1 * a1 * cn, s2 * a2 * sn, s3 * a3 * dn);
    if (is_other) std::swap(exact[0], exact[2]);
    errors.raise("omega_bar [rad/s]", (s.state.twist[0].omega_bar - exact).norm(), 1e-9);
  }
}

}  // namespace trivium::analytic
