/// Drivers and loads that fade, rise suddenly or lose their grip.

#include <cmath>

#include "scenes/testing/scene_builders.hpp"
#include "validation/testing/catalogue_motion.hpp"

namespace trivium {
namespace {

using test::catalogue_scene, test::InEveryFormulation, test::Motion, test::stepping, test::tight;

const scenes::Vector3 x{1, 0, 0}, z{0, 0, 1};

/// A wheel whose angle 0.5 + t is driven by a dp1. It turns steadily, without a load.
scenes::Scene wheel() {
  scenes::Scene scene;
  scene.name = "wheel";
  scene.bodies = {test::body("wheel", 1, {0.1, 0.1, 0.2})};
  scene.bodies[0].orientation = scenes::AxisAngle{z, 0.5};
  scene.bodies[0].angular_velocity = {0, 0, 1};
  scene.constraints = {
      test::joint(JointType::revolute, "axle", test::side(scenes::ground, scenes::Vector3{}, z),
                  test::side(0, scenes::Vector3{}, z)),
      test::joint(basic_type<DP1>, "drive", test::vector_side(scenes::ground, x), test::vector_side(0, x))};
  scene.constraints[1].f =
      TimeFunction(TimeFunction::Cos{{TimeFunction(TimeFunction::Polynomial{{0.5, 1}})}});
  return scene;
}

/// A slide along x, whose distance from the ground is driven from 1 m to `least` at t = 1 s and back.
scenes::Scene slide(double least) {
  scenes::Scene scene;
  scene.name = "slide";
  scene.bodies = {test::body("slide", 1, {1, 1, 1}, {1, 0, 0})};
  scene.bodies[0].velocity = {-2 * (1 - least), 0, 0};
  scene.constraints = {
      test::joint(JointType::translational, "guide", test::side(scenes::ground, scenes::Vector3{}, x, z),
                  test::side(0, scenes::Vector3{}, x, z)),
      test::joint(basic_type<D>, "drive", test::side(scenes::ground, scenes::Vector3{}),
                  test::side(0, scenes::Vector3{}))};
  const TimeFunction length(TimeFunction::Polynomial{{1, -2 * (1 - least), 1 - least}});
  scene.constraints[1].f = TimeFunction(TimeFunction::Product{{length, length}});
  return scene;
}

/// A puck of 1 kg under a force along x.
scenes::Scene puck(const TimeFunction& force) {
  scenes::Scene scene;
  scene.name = "puck";
  scene.bodies = {test::body("puck", 1, {1, 1, 1})};
  Force<double> push;
  push.body = 0;
  push.components[0] = force;
  scene.effects.emplace_back(push);
  return scene;
}

// Positions of a rounding become accelerations of 1e-6 rad/s^2, beside which the forces vanish.
TEST_P(InEveryFormulation, AWheelWithoutALoadTurnsSteadilyAtAnyStep) {
  for (const char* method : {"bdf", "generalized-alpha", "generalized-alpha-gl2", "hht"})
    for (const double h : {1e-2, 1e-3, 1e-4, 1e-5}) {
      const Motion motion(wheel(), stepping(GetParam(), method, h < 1e-4 ? 0.2 : 1, h));
      EXPECT_LE((motion.end().state.twist[0].omega_bar - Vector3<double>(0, 0, 1)).norm(), 1e-7 + 0.1 * h * h)
          << method << " " << h;
    }
}

/// cos^64, pulses of a tenth of a second, which no event marks.
TimeFunction smooth_pulses() {
  TimeFunction power(TimeFunction::Cos{{TimeFunction(TimeFunction::Polynomial{{0.5, 3.133}})}});
  for (int k = 0; k < 6; ++k) power = TimeFunction(TimeFunction::Product{{power, power}});
  return power;
}

// The error estimate of the method itself is 0 there.
TEST_P(InEveryFormulation, Rkf78SeesAPulseWithinAStep) {
  const Motion exact(puck(smooth_pulses()), stepping(GetParam(), "rkf78", 1, 1e-3));
  const auto error = [&](double rtol) {
    const Motion motion(puck(smooth_pulses()), tight(GetParam(), "rkf78", 1, rtol));
    return (motion.end().state.twist[0].r_dot - exact.end().state.twist[0].r_dot).norm();
  };
  for (const double rtol : {1e-4, 1e-6, 1e-8}) EXPECT_LE(error(rtol), 30 * rtol) << rtol;
}

// cos^64 falls to 1e-132 within a second, by up to 1e12 a step
TEST_P(InEveryFormulation, ALoadMayFadeToNothing) {
  for (const char* method : {"bdf", "generalized-alpha", "generalized-alpha-gl2", "hht"})
    EXPECT_EQ(Motion(puck(smooth_pulses()), stepping(GetParam(), method, 1, 1e-3)).end().state.t, 1)
        << method;
}

// The impulse is that of the function, whatever its width.
TEST_P(InEveryFormulation, RattleWithTolerancesFollowsASuddenPulse) {
  if (!goes_with(*integrators::find_method("rattle"), GetParam())) GTEST_SKIP();
  for (const double width : {0.1, 1e-3, 1e-5}) {
    const TimeFunction pulse(TimeFunction::Sum{{TimeFunction::Step5{0.5 - width, 0, 0.5, 1 / width},
                                                TimeFunction::Step5{0.5, 0, 0.5 + width, -1 / width}}});
    const Motion motion(puck(pulse), tight(GetParam(), "rattle", 1, 1e-8));
    EXPECT_NEAR(motion.end().state.twist[0].r_dot[0], 1, 2e-5) << width;
  }
}

// The motion is a polynomial of order 2, which ida follows with any step; the power is none.
TEST_P(InEveryFormulation, WorkIsAccurateWhereIdaFindsTheMotionEasy) {
  const Motion sliding(slide(0.5), tight(GetParam(), "ida", 2, 1e-8));
  EXPECT_LE(sliding.report.unaccounted_energy, 5e-4);
  const Motion linked(catalogue_scene("uwsbel_four_link"), tight(GetParam(), "ida", 3, 1e-8));
  EXPECT_LE(linked.report.unaccounted_energy, 3e-3 * linked.report.largest_kinetic);
}

// A slide that comes to rest at the ground can go on to either side; one that stops before it turns back.
TEST_P(InEveryFormulation, ADriverAtRestWithoutGripIsNamed) {
  SimulationOptions options = tight(GetParam(), "radau9", 2, 1e-8);
  options.output_step = 0.5;
  EXPECT_EQ(Motion(slide(1e-6), options).end().state.t, 2);
  try {
    const Motion motion(slide(0), options);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("driver \"drive\""), std::string::npos) << error.what();
    EXPECT_NEAR(error.when().value_or(0), 1, 1e-3);
  }
}

}  // namespace
}  // namespace trivium
