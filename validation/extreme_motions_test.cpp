/// Motions at the edge of what double precision holds, against closed solutions: fast tops, a separatrix,
/// singular positions, redundant joints, extreme masses, stiffnesses and sizes.

#include <algorithm>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "formulations/analysis/row_analysis.hpp"
#include "scenes/testing/scene_builders.hpp"
#include "validation/testing/catalogue_motion.hpp"

namespace trivium {
namespace {

using test::apart, test::catalogue_scene, test::InEveryFormulation, test::Motion, test::tight;

/// The height [m] at time t of the top of the catalogue, with another spin [rad/s]; it starts with a
/// horizontal axis. The cosine u of the inclination satisfies u'^2 = (b^2 - beta u)(1 - u^2) - (b - a u)^2,
/// whose right side is a cubic with the root 0 (Goldstein, Classical Mechanics, 5.7).
double height_of_top(double spin, double t) {
  const double A = 15 + 0.234375, a = 0.46875 * spin / A, b = -4.61538, beta = 2 * 15 * 9.81 / A,
               sum = (a * a + b * b) / beta, product = 2 * a * b / beta - 1,
               above = sum / 2 + std::sqrt(sum * sum / 4 - product), below = product / above;
  double cn, dn;
  boost::math::jacobi_elliptic(std::sqrt(-below / (above - below)), std::sqrt(beta * (above - below)) / 2 * t,
                               &cn, &dn);
  return below * (1 - cn * cn / (dn * dn));
}

TEST_P(InEveryFormulation, AFastTopIsFollowedOverTenSeconds) {
  for (const double spin : {150.0, 1000.0}) {
    scenes::Scene scene = catalogue_scene("heavy_top");
    scene.bodies[0].angular_velocity[1] = spin;
    const Motion motion(scene, tight(GetParam(), "rkf78", 10, 1e-12));
    // 1500 turns of r-p: its equations multiply an error of p' by the spin
    const double bound = GetParam() == "r-p" && spin > 150 ? 1e-8 : 1e-9;
    EXPECT_NEAR(motion.end().state.pose[0].r[2], height_of_top(spin, 10), bound) << spin;
  }
}

/// The time [s] in which a free body of moments J turns over once about its intermediate axis: half the
/// period 4 K(k) / p of omega_bar (Landau and Lifshitz, Mechanics, 37). K follows from the complementary
/// modulus by the arithmetic-geometric mean, without cancellation where k is nearly 1.
double time_of_a_flip(const scenes::Vector3& J, const scenes::Vector3& w) {
  const double above = J[0] * (J[0] - J[1]) * w[0] * w[0] + J[2] * (J[2] - J[1]) * w[2] * w[2],
               from_least = J[1] * (J[1] - J[0]) * w[1] * w[1] + J[2] * (J[2] - J[0]) * w[2] * w[2];
  double x = 1, y = std::sqrt((J[2] - J[0]) * above / ((J[2] - J[1]) * from_least));
  for (int k = 0; k < 8; ++k) {
    const double mean = (x + y) / 2;
    y = std::sqrt(x * y);
    x = mean;
  }
  return std::numbers::pi / x / std::sqrt((J[2] - J[1]) * from_least / (J[0] * J[1] * J[2]));
}

TEST(Dzhanibekov, ReturnsAfterAHundredFlips) {
  const scenes::Scene scene = catalogue_scene("dzhanibekov");
  const scenes::Body& body = scene.bodies[0];
  const scenes::Vector3 J = std::get<scenes::Vector3>(body.inertia), w = body.angular_velocity;
  const Motion motion(scene, tight("r-omega", "radau9", 100 * time_of_a_flip(J, w), 1e-11));
  const Vector3<double> start(w[0], w[1], w[2]);
  EXPECT_LE((motion.end().state.twist[0].omega_bar - start).norm(), 1e-7);
}

/// A crank of length 1 that turns at 3 rad/s at first, and a rod of the same length whose end slides along
/// the x axis, without gravity. Where the rod lies along the crank's way back, both can also turn together.
scenes::Scene rod_as_long_as_its_crank(double theta) {
  const scenes::Vector3 z{0, 0, 1}, back{-0.5, 0, 0}, front{0.5, 0, 0};
  const double c = std::cos(theta), s = std::sin(theta), omega = 3;
  scenes::Scene scene;
  scene.bodies = {test::body("crank", 1, {0.02, 0.1, 0.1}, {c / 2, s / 2, 0}),
                  test::body("rod", 1, {0.02, 0.1, 0.1}, {1.5 * c, s / 2, 0})};
  for (const int b : {0, 1}) {
    scene.bodies[b].orientation = scenes::AxisAngle{z, b == 0 ? theta : -theta};
    scene.bodies[b].angular_velocity = {0, 0, b == 0 ? omega : -omega};
    scene.bodies[b].velocity = {(b == 0 ? -0.5 : -1.5) * s * omega, c / 2 * omega, 0};
  }
  scene.constraints = {test::joint(JointType::revolute, "A", test::side(scenes::ground, scenes::Vector3{}, z),
                                   test::side(0, back, z)),
                       test::joint(JointType::revolute, "B", test::side(0, front, z), test::side(1, back, z)),
                       test::joint(basic_type<CD>, "slide", test::side(scenes::ground, scenes::Vector3{}),
                                   test::side(1, front))};
  scene.constraints.back().direction = {0, 1, 0};
  return scene;
}
/// The crank's angle after a time. The kinetic energy I(theta) theta'^2 / 2 does not change. By Runge-Kutta
/// steps of order 4, far shorter than needed.
double angle_of_crank(double theta, double t) {
  const auto inertia = [](double angle) {
    const double s2 = std::sin(angle) * std::sin(angle);
    return (0.1 + 0.25) + (0.1 + 2.25 * s2 + 0.25 * (1 - s2));
  };
  const double momentum = std::sqrt(inertia(theta)) * 3;
  const auto rate = [&](double angle) { return momentum / std::sqrt(inertia(angle)); };
  constexpr int steps = 20000;
  const double h = t / steps;
  for (int n = 0; n < steps; ++n) {
    const double k1 = rate(theta), k2 = rate(theta + h / 2 * k1), k3 = rate(theta + h / 2 * k2),
                 k4 = rate(theta + h * k3);
    theta += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return theta;
}

TEST_P(InEveryFormulation, ARodAsLongAsItsCrankPassesItsDeadPoints) {
  const double theta = angle_of_crank(0.3, 5);  // after two turns
  const Vector3<double> exact(1.5 * std::cos(theta), 0.5 * std::sin(theta), 0);
  for (const auto& [method, bound] : {std::pair("dopri5", 2e-7), {"radau5", 1e-8}}) {
    const Motion motion(rod_as_long_as_its_crank(0.3), tight(GetParam(), method, 5, 1e-8));
    EXPECT_LE((motion.end().state.pose[1].r - exact).norm(), bound) << method;
  }
}

TEST_P(InEveryFormulation, AFlatParallelogramKeepsItsForm) {
  const scenes::Scene scene = test::hard_scene("flat_par");
  const Vector3<double> exact(0.5 * std::cos(1 + 3 * 10.0), 0.5 * std::sin(1 + 3 * 10.0), 0);
  for (const auto& [method, bound] : {std::pair("dopri5", 1e-6), {"radau5", 3e-8}}) {
    const Motion motion(scene, tight(GetParam(), method, 10, 1e-8));
    EXPECT_LE((motion.end().state.pose[0].r - exact).norm(), bound) << method;
  }
}

TEST_P(InEveryFormulation, TripledJointsChangeNothing) {
  for (const char* name : {"four_bar", "bricard", "door", "spatial_slider_crank", "andrews_squeezer",
                           "double_pendulum", "stewart_platform"}) {
    const scenes::Scene scene = catalogue_scene(name);
    scenes::Scene tripled = scene;
    for (const char* copy : {"'", "''"})
      for (scenes::Constraint joint : scene.constraints) {
        joint.name += copy;
        tripled.constraints.push_back(joint);
      }
    EXPECT_EQ(analyse_rows(make_model<double>(tripled)).rank, analyse_rows(make_model<double>(scene)).rank)
        << name;
    const SimulationOptions options = tight(GetParam(), "dopri5", 1e-3);
    const MotionSample once = Motion(scene, options).samples.front(),
                       thrice = Motion(tripled, options).samples.front();
    double largest = 0, off = 0;
    for (std::size_t b = 0; b < once.r_ddot.size(); ++b)
      for (const auto& [x, y] : {std::pair(once.r_ddot[b], thrice.r_ddot[b]),
                                 std::pair(once.omega_bar_dot[b], thrice.omega_bar_dot[b])}) {
        raise(largest, x.norm());
        raise(off, (x - y).norm());
      }
    EXPECT_LE(off, 1e-14 * largest) << name;
  }
}

TEST_P(InEveryFormulation, AChainOfAnyMassesIsFollowed) {
  const scenes::Vector3 z{0, 0, 1}, back{-0.5, 0, 0}, front{0.5, 0, 0};
  for (const double ratio : {1e-12, 1e-6, 1e6, 1e12}) {
    scenes::Scene scene;
    scene.bodies = {test::body("a", 1, {0.1, 0.1, 0.1}, {0.5, 0, 0}),
                    test::body("b", ratio, {0.1 * ratio, 0.1 * ratio, 0.1 * ratio}, {1.5, 0, 0})};
    scene.constraints = {
        test::joint(JointType::revolute, "A", test::side(scenes::ground, scenes::Vector3{}, z),
                    test::side(0, back, z)),
        test::joint(JointType::revolute, "B", test::side(0, front, z), test::side(1, back, z))};
    scene.effects = {Gravity<double>{"", {0, -9.81, 0}}};
    EXPECT_LE(apart(Motion(scene, tight(GetParam(), "radau5", 1, 1e-10)),
                    Motion(scene, tight("r-omega", "rkf78", 1, 1e-12))),
              2e-9)
        << ratio;
  }
}

// The spring's tension keeps the body on a circle of radius 1.
TEST_P(InEveryFormulation, ABodyOnAStiffSpringStaysOnItsOrbit) {
  constexpr double omega = 10;
  for (const double stiffness : {1e6, 1e8, 1e10}) {
    scenes::Scene scene;
    scene.bodies = {test::body("stone", 1, {0.1, 0.1, 0.1}, {1, 0, 0})};
    scene.bodies[0].velocity = {0, omega, 0};
    SpringDamper<double> spring;
    spring.i.body = scenes::ground;
    spring.j.body = 0;
    spring.stiffness = stiffness;
    spring.free_length = 1 - omega * omega / stiffness;
    scene.effects = {spring};
    const Motion motion(scene, tight(GetParam(), "radau5", 1, 1e-10));
    const Vector3<double> exact(std::cos(omega), std::sin(omega), 0);
    EXPECT_LE((motion.end().state.pose[0].r - exact).norm(), 2e-9) << stiffness;
  }
}

// Lengths times L and accelerations times g give the same path in sqrt(L / g) times the time.
TEST_P(InEveryFormulation, NeitherSizeNorGravityChangesTheMotion) {
  const auto scaled = [](double length, double gravity) {
    scenes::Scene scene;
    scene.bodies = {test::body("bob", 1, {0.1, 0.2, 0.25}, {1, 0, 0})};
    scene.constraints = {test::joint(JointType::spherical, "pivot",
                                     test::side(scenes::ground, scenes::Vector3{}),
                                     test::side(0, scenes::Vector3{-length, 0, 0}))};
    for (double& moment : std::get<scenes::Vector3>(scene.bodies[0].inertia)) moment *= length * length;
    scene.bodies[0].position[0] = length;
    scene.effects = {test::gravity(9.81 * gravity)};
    return scene;
  };
  const Motion exact(scaled(1, 1), tight("r-omega", "rkf78", 2, 1e-12));
  for (const double length : {1e-9, 1e-6, 1e-3, 1e3})
    for (const double gravity : {1e-9, 1.0, 1e9}) {
      SimulationOptions options = tight(GetParam(), "dopri5", 2 * std::sqrt(length / gravity), 1e-8);
      const Motion motion(scaled(length, gravity), options);
      EXPECT_LE((motion.end().state.pose[0].r / length - exact.end().state.pose[0].r).norm(), 5e-6)
          << length << " " << gravity;
    }
}

}  // namespace
}  // namespace trivium
