/// Motions at the edge of what double precision holds, against closed solutions: fast tops, a separatrix,
/// singular positions, redundant joints, extreme masses, stiffnesses and sizes.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "formulations/analysis/row_analysis.hpp"
#include "scenes/testing/scene_builders.hpp"
#include "validation/hard/known_motions.hpp"
#include "validation/testing/catalogue_motion.hpp"

namespace trivium {
namespace {

using test::apart, test::catalogue_scene, test::InEveryFormulation, test::Motion, test::tight;

TEST_P(InEveryFormulation, AFastTopIsFollowedOverTenSeconds) {
  for (const double spin : {150.0, 1000.0}) {
    scenes::Scene scene = catalogue_scene("heavy_top");
    scene.bodies[0].angular_velocity[1] = spin;
    const Motion motion(scene, tight(GetParam(), "rkf78", 10, 1e-12));
    // 1500 turns of r-p: its equations multiply an error of p' by the spin
    const double bound = GetParam() == "r-p" && spin > 150 ? 1e-8 : 1e-9;
    EXPECT_NEAR(motion.end().state.pose[0].r[2], hard::height_of_top(spin, 10), bound) << spin;
  }
}

TEST(Dzhanibekov, ReturnsAfterAHundredFlips) {
  const scenes::Scene scene = catalogue_scene("dzhanibekov");
  const scenes::Vector3& w = scene.bodies[0].angular_velocity;
  const Motion motion(scene, tight("r-omega", "radau9", 100 * hard::time_of_a_flip(scene.bodies[0]), 1e-11));
  const Vector3<double> start(w[0], w[1], w[2]);
  EXPECT_LE((motion.end().state.twist[0].omega_bar - start).norm(), 1e-7);
}

TEST_P(InEveryFormulation, ARodAsLongAsItsCrankPassesItsDeadPoints) {
  MechanismState<double> exact = hard::state_of_size(2);
  exact.t = 5;  // after two turns
  hard::set_rod_on_crank(exact, 3);
  for (const auto& [method, bound] : {std::pair("dopri5", 2e-7), {"radau5", 1e-8}}) {
    const Motion motion(hard::rod_on_crank(3), tight(GetParam(), method, 5, 1e-8));
    EXPECT_LE((motion.end().state.pose[1].r - exact.pose[1].r).norm(), bound) << method;
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

// The rod holds the slider by a pivot that falls with the mass of the rod, as at a singular position.
TEST_P(InEveryFormulation, ALightRodInALoopMakesNoSingularPosition) {
  const auto with_rod = [](double ratio) {
    scenes::Scene scene = catalogue_scene("spatial_slider_crank");
    scene.effects = {test::gravity(9.81)};
    scene.bodies[1].mass *= ratio;
    for (double& moment : std::get<scenes::Vector3>(scene.bodies[1].inertia)) moment *= ratio;
    return scene;
  };
  const Motion without_mass(with_rod(1e-15), tight("r-omega", "rkf78", 0.5, 1e-11));
  for (const double ratio : {1e-8, 1e-9, 3e-10, 1e-11})
    for (const char* method : {"dopri5", "radau5", "generalized-alpha"}) {
      const Motion motion(with_rod(ratio), tight(GetParam(), method, 0.5, 1e-8));
      EXPECT_TRUE(motion.report.passages.empty()) << ratio << " " << method;
      EXPECT_LE(apart(motion, without_mass), 1e-6) << ratio << " " << method;
    }
}

TEST_P(InEveryFormulation, ABodyOnAStiffSpringStaysOnItsOrbit) {
  MechanismState<double> exact = hard::state_of_size(1);
  exact.t = 1;
  hard::set_orbit(exact);
  for (const double stiffness : {1e6, 1e8, 1e10}) {
    const Motion motion(hard::orbit_on_spring(stiffness), tight(GetParam(), "radau5", 1, 1e-10));
    EXPECT_LE((motion.end().state.pose[0].r - exact.pose[0].r).norm(), 2e-9) << stiffness;
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
