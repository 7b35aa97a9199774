/// Simulations over events: jumps of velocities, and kinks of functions of time.

#include <cmath>

#include "integrators/methods.hpp"
#include "scenes/testing/scene_builders.hpp"
#include "scenes/testing/two_link_arm.hpp"
#include "validation/testing/catalogue_motion.hpp"

namespace trivium {
namespace {

using test::in_quad, test::InEveryFormulation, test::Motion, test::stepping, test::tight,
    test::wellformed_scene;

// The bob hangs straight below its hook. An impulse J at the hook changes the hook's speed by 1 m/s = J (1/m
// + l^2/I).
TEST_P(InEveryFormulation, ADriverWhoseSpeedJumpsStrikesWithAnImpulse) {
  const scenes::Scene scene = wellformed_scene("jerked_trolley");
  const double on_bob = 1 / (1.0 / 2 + 0.25 / 0.1), impulse = 3 + on_bob;
  SimulationOptions options = tight(GetParam(), "rkf78", 0.5, 1e-10);
  const Motion struck(scene, [&] {
    options.end = 0.51;
    options.output_step = 0.5;
    return options;
  }());
  const MotionSample& after = struck.samples[1];
  EXPECT_EQ(after.state.t, 0.5);
  EXPECT_NEAR(after.state.twist[0].r_dot[0], 1.4, 1e-12);
  EXPECT_NEAR(after.state.twist[1].r_dot[0], 0.4 + on_bob / 2, 1e-12);
  EXPECT_NEAR(after.state.twist[1].omega_bar[1], 0.5 * on_bob / 0.1, 1e-11);
  ASSERT_EQ(struck.report.impulses.size(), 1u);
  EXPECT_EQ(struck.report.impulses[0].t, 0.5);
  EXPECT_NEAR(struck.report.impulses[0].lambda[5], -impulse, 1e-11);  // row 5: the rail has rows 0 to 4
  EXPECT_NEAR(after.energy - struck.samples[0].energy, impulse * (0.4 + 1.4) / 2, 1e-11);
  EXPECT_LE(struck.report.unaccounted_energy, 1e-10);
}

/// A two-link arm. A driven row d moves its end away from the base; at t = 2 the arm is stretched.
scenes::Scene reaching_arm() {
  scenes::Scene scene = test::two_link_arm(std::acos(0.0));
  scene.name = "reaching arm";
  scene.constraints[2].f = TimeFunction(TimeFunction::Polynomial{{2, 0, 0.5}});
  scene.effects = {Gravity<double>{"", {0, -9.81, 0}}};
  return scene;
}

TEST_P(InEveryFormulation, ADriverThatDemandsTooMuchIsNamedAtTheEndOfItsReach) {
  for (const integrators::MethodInfo& method : integrators::methods()) {
    if (!goes_with(method, GetParam())) continue;
    SimulationOptions options = tight(GetParam(), std::string(method.name), 3, 1e-6);
    if (!method.chooses_steps) options.step = 1e-3;
    try {
      const Motion motion(reaching_arm(), options);
      ADD_FAILURE() << method.name;
    } catch (const Error& error) {
      const std::string what = error.what();
      EXPECT_NE(what.find("driver \"drive\" demands f = "), std::string::npos) << method.name << ": " << what;
      const std::string demands = "demands f = ", within_reach = "only values up to about ";
      EXPECT_GT(std::stod(what.substr(what.find(demands) + demands.size())), 4)  // the arm's length squared
          << method.name << ": " << what;
      const std::size_t at = what.find(within_reach);
      ASSERT_NE(at, std::string::npos) << method.name << ": " << what;
      EXPECT_NEAR(std::stod(what.substr(at + within_reach.size())), 4, 1e-3) << method.name << ": " << what;
      ASSERT_TRUE(error.when().has_value()) << method.name;
      EXPECT_NEAR(*error.when(), 2, 2e-3) << method.name;
    }
  }
}

// Steps that cannot be shortened fail earlier, and often at a neighbouring row.
TEST_P(InEveryFormulation, ADriverThatDemandsTooMuchIsNamedAtGivenStepsToo) {
  for (const integrators::MethodInfo& method : integrators::methods()) {
    if (!goes_with(method, GetParam()) || !method.takes_given_steps) continue;
    for (const double step : {1e-2, 1e-3}) try {
        const Motion motion(reaching_arm(), stepping(GetParam(), std::string(method.name), 3, step));
        ADD_FAILURE() << method.name;
      } catch (const Error& error) {
        const std::string what = error.what();
        EXPECT_NE(what.find("driver \"drive\" demands f = "), std::string::npos)
            << method.name << ", " << step << ": " << what;
        EXPECT_EQ(what.find("take smaller steps"), std::string::npos) << what;
        EXPECT_NEAR(*error.when(), 2, 1.5 * step) << method.name;
      }
  }
}

// lift2, at half the way along the link, should rise half as far
TEST_P(InEveryFormulation, DriversThatContradictEachOtherAreNamed) {
  scenes::Scene scene;
  scene.name = "contradiction";
  scene.bodies = {test::body("link", 1, {0.01, 0.1, 0.1}, {1, 0, 0})};
  const scenes::Vector3 z{0, 0, 1};
  const auto lift = [&](const char* name, double at, std::vector<double> coefficients) {
    auto row = test::joint(basic_type<CD>, name, test::side(scenes::ground, scenes::Vector3{}),
                           test::side(0, scenes::Vector3{at, 0, 0}));
    row.direction = {0, 1, 0};
    row.f = TimeFunction(TimeFunction::Polynomial{std::move(coefficients)});
    return row;
  };
  scene.constraints = {
      test::joint(JointType::revolute, "hinge", test::side(scenes::ground, scenes::Vector3{}, z),
                  test::side(0, scenes::Vector3{-1, 0, 0}, z)),
      lift("lift", 0, {0, 0, 0.1}), lift("lift2", -0.5, {0, 0, 0.05, 0.02})};
  for (const char* method : {"dopri5", "radau5", "generalized-alpha", "ida", "cvode-bdf"}) try {
      const Motion motion(scene, tight(GetParam(), method, 1, 1e-8));
      ADD_FAILURE() << method;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("driver \"lift\", driver \"lift2\""), std::string::npos)
          << method << ": " << error.what();
    }
}

// At t = 2 the pendulum's driver has nearly no grip, but does not demand too much.
TEST_P(InEveryFormulation, AHealthyDriverIsNotBlamedForAnother) {
  scenes::Scene scene = reaching_arm();
  const scenes::Vector3 z{0, 0, 1};
  scene.bodies.push_back(test::body("c", 1, {0.02, 0.03, 0.025}, {6, 0, 0}));
  scene.bodies[2].angular_velocity = {0, 0, 0.9995 * std::acos(0.0) / 2};
  scene.bodies[2].velocity = {0, scene.bodies[2].angular_velocity[2], 0};
  scene.constraints.push_back(test::joint(JointType::revolute, "C",
                                          test::side(scenes::ground, scenes::Vector3{5, 0, 0}, z),
                                          test::side(2, scenes::Vector3{-1, 0, 0}, z)));
  auto healthy = test::joint(basic_type<CD>, "healthy", test::side(scenes::ground, scenes::Vector3{}),
                             test::side(2, scenes::Vector3{}));
  healthy.direction = {0, 1, 0};
  healthy.f = TimeFunction(TimeFunction::Harmonic{0, 0.9995, std::acos(0.0) / 2, 0});
  scene.constraints.push_back(healthy);
  for (const char* method : {"radau5", "dopri5", "bdf", "generalized-alpha", "hedop5"}) {
    try {
      const Motion motion(scene, stepping(GetParam(), method, 3, 1e-3));
      ADD_FAILURE() << method;
    } catch (const Error& error) {
      const std::string what = error.what();
      EXPECT_NE(what.find("driver \"drive\" demands f = "), std::string::npos) << method << ": " << what;
    }
    scenes::Scene alone = scene;
    alone.constraints.erase(alone.constraints.begin() + 2);  // without "drive"
    EXPECT_NO_THROW(Motion(alone, stepping(GetParam(), method, 3, 1e-3))) << method;
  }
}

// Steps of radau5 at a tolerance of 0.1 are longer than a period of the driven angle.
TEST(Branches, AnotherBranchThanThatOfTheStartIsAnErrorInDoubleAndInQuad) {
  const scenes::Vector3 z{0, 0, 1}, x{1, 0, 0};
  scenes::Scene scene;
  scene.bodies = {test::body("b", 1, {0.1, 0.1, 0.1}, {0.1, 0, 0})};
  scene.bodies[0].velocity = {0, 300, 0};
  scene.bodies[0].angular_velocity = {0, 0, 3000};
  auto driver = test::joint(JointType::rotation_driver, "d", test::side(scenes::ground, {}, z, x),
                            test::side(0, {}, z, x));
  driver.angle = TimeFunction(TimeFunction::Harmonic{0, 1.5, 2000, 0});
  scene.constraints = {test::joint(JointType::revolute, "r", test::side(scenes::ground, {}, z, x),
                                   test::side(0, scenes::Vector3{-0.1, 0, 0}, z, x)),
                       driver};
  SimulationOptions options;
  options.integrator = "radau5";
  options.tolerances = {0.1, 0.1};
  options.output_step = 0.005;
  options.end = 1;
  for (const bool quad : {false, in_quad}) try {
      const Motion motion(scene, options, quad);
      ADD_FAILURE() << quad;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("changed to another branch: joint \"d\""), std::string::npos)
          << error.what();
    }
}

// The state at the end is the state after the jump.
TEST_P(InEveryFormulation, AJumpAtTheEndOfTheRunIsStillPassed) {
  for (const char* method :
       {"dopri5", "cvode-bdf", "ida", "radau5", "radau9", "hedop5", "generalized-alpha", "bdf"}) {
    SimulationOptions options = tight(GetParam(), method, 0.5, 1e-9);
    if (!integrators::find_method(method)->chooses_steps) options.step = 0.001;
    const Motion motion(wellformed_scene("jerked_trolley"), options);
    ASSERT_EQ(motion.report.impulses.size(), 1u) << method;
    EXPECT_NEAR(motion.end().state.twist[0].r_dot[0], 1.4, 1e-9) << method;
  }
}

TEST_P(InEveryFormulation, EveryMethodGoesOverAJumpOfVelocities) {
  const scenes::Scene scene = wellformed_scene("jerked_trolley");
  const Motion exact(scene, tight("r-omega", "rkf78", 1, 1e-12));
  ASSERT_EQ(exact.report.impulses.size(), 2u);
  for (const char* method : {"dopri5", "bulirsch-stoer", "abm", "cvode-adams", "cvode-bdf", "arkode-erk",
                             "arkode-dirk", "ida", "radau5", "radau9", "generalized-alpha",
                             "generalized-alpha-gl2", "bdf", "hem4", "hedop5", "rattle", "rattle4"}) {
    if (!goes_with(*integrators::find_method(method), GetParam())) continue;
    SimulationOptions options = tight(GetParam(), method, 1, 1e-9);
    // methods of low order take given steps: their own multipliers are not exact to 1e-5 at chosen ones
    const integrators::MethodInfo& info = *integrators::find_method(method);
    const bool steps = info.takes_given_steps && info.standard_order <= 4;
    if (steps) options.step = 0.001;
    const Motion motion(scene, options);
    ASSERT_EQ(motion.report.impulses.size(), 2u) << method;
    for (int k = 0; k < 2; ++k)
      EXPECT_NEAR(motion.report.impulses[k].lambda[5], exact.report.impulses[k].lambda[5],
                  steps ? 1e-3 : 1e-6)
          << method;
    for (int b = 0; b < 2; ++b)
      EXPECT_LE((motion.end().state.pose[b].r - exact.end().state.pose[b].r).norm(), steps ? 1e-4 : 1e-6)
          << method;
    EXPECT_LE(motion.report.phi, 1e-12) << method;
    EXPECT_LE(motion.report.unaccounted_energy, steps ? 1e-4 : 1e-6) << method;
    // at the event the method's own multipliers are those before the jump
    EXPECT_LE(motion.report.lambda_gap, steps ? 1e-2 : 1e-5) << method;
  }
}

// A method of order 8 integrates each piece of the quintic exactly, but not a step across a kink.
TEST_P(InEveryFormulation, KinksOfAFunctionOfTimeAreLandedOn) {
  scenes::Scene scene;
  scene.name = "pushed";
  scene.bodies.push_back(test::body("puck", 1, {1, 1, 1}));
  Force<double> push;
  push.body = 0;
  push.components[0] = TimeFunction::Step5{0.13, 0, 0.77, 1};
  scene.effects.emplace_back(push);
  SimulationOptions options;
  options.formulation = GetParam();
  options.integrator = "rkf78";
  options.end = 1;
  options.step = 0.25;
  EXPECT_NEAR(Motion(scene, options).end().state.twist[0].r_dot[0], (0.77 - 0.13) / 2 + (1 - 0.77), 1e-14);
}

}  // namespace
}  // namespace trivium
