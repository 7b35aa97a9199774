/// Problems whose solutions are curves of MSC ADAMS (declared in problems.hpp).

#include <algorithm>

#include "formulations/r_omega.hpp"
#include "formulations/structured/acceleration_solver.hpp"
#include "scenes/make_mechanism.hpp"
#include "validation/analytic/problems.hpp"
#include "validation/harness/trusted_numbers.hpp"

namespace trivium::analytic {

/// Compares poses, velocities, accelerations, and the force and torque of the joint on the ground with curves
/// of MSC ADAMS. These curves are accurate to about 5e-6 m, on the universal joint to 1e-3 m, as the exact
/// solutions of the same pendulums show. `looser` is the factor by which the bounds are widened for a less
/// accurate curve.
void adams(const std::string& name, double looser, const std::string& formulation, Errors& errors) {
  const TrustedNumbers file(reference_directory(), name);
  const scenes::Scene scene = catalogue_scene(name);
  const auto mechanism = make_mechanism<double>(scene);
  AccelerationSolver<ROmega<double>> solver(mechanism);
  const std::vector<MotionSample> samples = motion(scene, formulation, 5, 0.1);
  const auto column = [&](const std::string& stem, std::size_t row) {
    return Vector(file[stem + "x"][row], file[stem + "y"][row], file[stem + "z"][row]);
  };
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const MotionSample& s = samples[k];
    const Pose<double>& pose = s.state.pose[0];
    const Matrix3<double> A = rotation_matrix(pose.p);
    solver.solve(to_coordinates<ROmega<double>>(mechanism, s.state, {}), s.state.t);
    const Vector4<double> p(file["e0"][k], file["e1"][k], file["e2"][k], file["e3"][k]);
    errors.raise("position [m]", (pose.r - column("", k)).norm(), 1e-4 * looser);
    errors.raise("velocity [m/s]", (s.state.twist[0].r_dot - column("v", k)).norm(), 2e-4 * looser);
    errors.raise("acceleration [m/s^2]", (solver.r_ddot(0) - column("a", k)).norm(), 1e-3 * looser);
    errors.raise("orientation [rad]", 2 * std::min((pose.p - p).norm(), (pose.p + p).norm()), 1e-4 * looser);
    errors.raise("angular velocity [rad/s]", (A * s.state.twist[0].omega_bar - column("w", k)).norm(),
                 1e-4 * looser);
    errors.raise("angular acceleration [rad/s^2]", (A * solver.omega_bar_dot(0) - column("alpha", k)).norm(),
                 1e-3 * looser);
    errors.raise("force [N]", (-s.reactions[0].force - column("f", k)).norm(), 1e-3 * looser);
    errors.raise("torque [N m]", (-s.reactions[0].torque - column("t", k)).norm(), 1e-3);
  }
}

}  // namespace trivium::analytic
