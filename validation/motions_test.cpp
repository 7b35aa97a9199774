/// Motions against trusted numbers, in every formulation: what users run as `trivium simulate`.

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "integrators/methods.hpp"
#include "scenes/generators.hpp"
#include "scenes/testing/scene_builders.hpp"
#include "validation/harness/trusted_numbers.hpp"
#include "validation/testing/catalogue_motion.hpp"

namespace trivium {
namespace {

using test::catalogue_scene, test::in_quad, test::Motion, test::tight;

class InEveryFormulation : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Motions, InEveryFormulation, testing::ValuesIn(formulation_names()),
                         test::formulation_in_a_name);

TEST_P(InEveryFormulation, ThePendulumIsThatOfEllipticFunctions) {
  const Reference exact(TRIVIUM_REFERENCE_DIR, "a01_pendulum");
  for (const char* method : {"dopri5", "rkf78", "bulirsch-stoer", "abm"}) {
    SimulationOptions options = tight(GetParam(), method, 10);
    options.output_step = 0.1;
    const Motion motion(catalogue_scene("a01_pendulum"), options);
    ASSERT_EQ(motion.samples.size(), exact.rows());
    for (std::size_t k = 0; k < exact.rows(); ++k) {
      const auto& r = motion.samples[k].state.pose[0].r;
      EXPECT_NEAR(motion.samples[k].state.t, exact["t"][k], 1e-14);
      EXPECT_LE(std::hypot(r[0] - exact["x"][k], r[1] - exact["y"][k]), 1e-10)
          << method << " " << exact["t"][k];
      EXPECT_NEAR(motion.samples[k].reactions[0].force.norm(), std::abs(exact["tension"][k]), 1e-8);
    }
  }
}

TEST_P(InEveryFormulation, TheHeavyTopIsThatOfTheReference) {
  const Reference exact(TRIVIUM_REFERENCE_DIR, "heavy_top");
  SimulationOptions options = tight(GetParam(), "rkf78", 2);
  options.output_step = 0.02;
  const Motion motion(catalogue_scene("heavy_top"), options);
  ASSERT_EQ(motion.samples.size(), exact.rows());
  for (std::size_t k = 0; k < exact.rows(); ++k) {
    const auto& s = motion.samples[k];
    for (const auto& [axis, name] : {std::pair(0, "x"), {1, "y"}, {2, "z"}})
      EXPECT_NEAR(s.state.pose[0].r[axis], exact[name][k], 1e-9) << exact["t"][k];
    for (const auto& [axis, name] : {std::pair(0, "fx"), {1, "fy"}, {2, "fz"}})
      EXPECT_NEAR(s.reactions[0].force[axis], exact[name][k], 1e-6) << exact["t"][k];
  }
}

TEST_P(InEveryFormulation, TheSpatialSliderCrankIsThatOfTheReference) {
  const Reference exact(TRIVIUM_REFERENCE_DIR, "spatial_slider_crank");
  SimulationOptions options = tight(GetParam(), "rkf78", 5);
  options.output_step = 0.1;
  const Motion motion(catalogue_scene("spatial_slider_crank"), options);
  ASSERT_EQ(motion.samples.size(), exact.rows());
  for (std::size_t k = 0; k < exact.rows(); ++k)
    EXPECT_NEAR(motion.samples[k].state.pose[2].r[0], exact["slider_x"][k], 1e-9) << exact["t"][k];
}

TEST_P(InEveryFormulation, AndrewsSqueezerIsThatOfTheReference) {
  const Reference exact(TRIVIUM_REFERENCE_DIR, "andrews_squeezer");
  const Motion motion(catalogue_scene("andrews_squeezer"), tight(GetParam(), "rkf78", 0.03, 1e-13));
  const auto angles = andrews_angles(exact);
  for (std::size_t b = 0; b < angles.size(); ++b)
    EXPECT_LE(apart_from_angle(motion.end().state.pose[b].p, angles[b]), 1e-9) << b;
  // of the joints at E, forces on the body that is not K2
  for (const auto& [joint, k] : {std::pair(2, 1), {3, 3}, {4, 5}}) {
    const auto& force = motion.end().reactions[joint].force;
    const double x = exact.value("lambda" + std::to_string(k)),
                 y = exact.value("lambda" + std::to_string(k + 1));
    EXPECT_LE(std::hypot(-force[0] - x, -force[1] - y), 1e-7 * std::hypot(x, y)) << force.transpose();
  }
}

TEST_P(InEveryFormulation, FortyFourBarsPassTheirSingularPositions) {
  const Reference exact(TRIVIUM_REFERENCE_DIR, "n_four_bar_40");
  SimulationOptions options = tight(GetParam(), "dopri5", 10, 1e-9);
  options.output_step = 5;
  const Motion motion(catalogue_scene("n_four_bar_40"), options);
  // the last coupler's centre is at (39.5, 0) from B0
  for (const auto& [sample, row] : {std::pair(1, 50), {2, 100}}) {
    ASSERT_EQ(exact["t"][row], motion.samples[sample].state.t);
    const auto& r = motion.samples[sample].state.pose.back().r;
    EXPECT_LE(std::hypot(r[0] - 39.5 - exact["x"][row], r[1] - exact["y"][row]), 1e-6);
  }
  EXPECT_FALSE(motion.report.passages.empty());
}

// one of its loops needs one row of two, and each of these vanishes somewhere: neither place is singular
TEST_P(InEveryFormulation, ChoicesOfRowsThatVanishAreNoSingularPositions) {
  const Motion motion(catalogue_scene("parallelogram"), tight(GetParam(), "rkf78", 2));
  EXPECT_TRUE(motion.report.passages.empty());
  EXPECT_LE(motion.report.unaccounted_energy, 1e-9);
  EXPECT_LE(motion.report.phi, 1e-11);  // after every step, those beside the place where it lies flat too
}

// cos(theta) = f(t) at f = -1: the crank goes on, in all formulations, at all tolerances
TEST_P(InEveryFormulation, ACosineDriverPassesItsDeadPoint) {
  for (const double rtol : {1e-6, 1e-8, 1e-10}) {
    const Motion motion(catalogue_scene("uwsbel_four_link"), tight(GetParam(), "dopri5", 1, rtol));
    EXPECT_NEAR(motion.end().state.pose[2].r[0], -2.43744228108569, 1e-9) << rtol;
    EXPECT_LE(motion.end().phi, 1e-13);
  }
}

TEST_P(InEveryFormulation, BricardIsThatOfAnotherMethodAtATighterTolerance) {
  static const MotionSample exact =
      Motion(catalogue_scene("bricard"), tight("r-omega", "bulirsch-stoer", 10, 1e-14)).end();
  const Motion motion(catalogue_scene("bricard"), tight(GetParam(), "rkf78", 10));
  for (std::size_t b = 0; b < exact.state.pose.size(); ++b)
    EXPECT_LE((motion.end().state.pose[b].r - exact.state.pose[b].r).norm(), 1e-8);
}

// of r, v and lambda, in quad so that no rounding hides it
TEST_P(InEveryFormulation, GivenStepsConvergeWithThePublishedOrder) {
  const scenes::Scene scene = catalogue_scene("parallelogram");
  static const MotionSample exact = Motion(scene, tight("r-omega", "rkf78", 0.4, 1e-20), in_quad).end();
  const auto errors = [&](const std::string& method, int steps) {
    SimulationOptions options;
    options.formulation = GetParam();
    options.integrator = method;
    options.end = 0.4;
    options.step = 0.4 / steps;
    const MotionSample end = Motion(scene, options, in_quad).end();
    Vector3<double> error = Vector3<double>::Zero();
    for (std::size_t b = 0; b < exact.state.pose.size(); ++b) {
      error[0] = std::max(error[0], (end.state.pose[b].r - exact.state.pose[b].r).norm());
      error[1] = std::max(error[1], (end.state.twist[b].omega_bar - exact.state.twist[b].omega_bar).norm());
    }
    error[2] = (end.lambda - exact.lambda).norm();
    return error;
  };
  for (const auto& [method, steps] : {std::pair("dopri5", 80), {"abm", 160}}) {
    const Vector3<double> coarse = errors(method, steps), fine = errors(method, 2 * steps);
    for (const auto& [k, of] : {std::pair(0, "r"), {1, "v"}, {2, "lambda"}})
      EXPECT_NEAR(std::log2(coarse[k] / fine[k]), 5, 0.2)
          << method << " " << of << " " << coarse.transpose() << " to " << fine.transpose();
  }
}

// the same lambda, in all formulations, wherever the motion goes
TEST_P(InEveryFormulation, LambdaAlongAMotionIsThatOfROmega) {
  for (const char* name : {"spatial_slider_crank", "stewart_platform", "bricard", "triple_pendulum"}) {
    SimulationOptions options = tight(GetParam(), "rkf78", 1, 1e-13);
    options.output_step = 0.1;
    const Motion motion(catalogue_scene(name), options);
    options.formulation = "r-omega";
    const Motion by_omega(catalogue_scene(name), options);
    for (std::size_t k = 0; k < motion.samples.size(); ++k) {
      const VectorX<double>& lambda = by_omega.samples[k].lambda;
      EXPECT_LE((motion.samples[k].lambda - lambda).norm(), 1e-10 * lambda.norm())
          << name << " " << motion.samples[k].state.t;
    }
  }
}

TEST_P(InEveryFormulation, WorkOfDriversAndDampersAccountsForTheEnergy) {
  for (const char* name : {"driven_crank", "basic_drivers", "open_arm_7", "flyball_governor"}) {
    const bool is_stiff = std::string(name) == "flyball_governor";
    const Motion motion(catalogue_scene(name), tight(GetParam(), "dopri5", is_stiff ? 0.05 : 1, 1e-10));
    EXPECT_TRUE(motion.report.does_work);
    EXPECT_GT(std::abs(motion.report.work), 1e-3) << name;
    EXPECT_LE(motion.report.unaccounted_energy, 1e-7 * (1 + std::abs(motion.report.energy_start))) << name;
  }
}

// three turns of a spring, then back: theta = 6 pi cos(t)
TEST_P(InEveryFormulation, ATorsionalSpringIsCountedOverFullTurns) {
  scenes::Scene scene;
  scene.name = "wound_up";
  scene.bodies.push_back(test::body("rotor", 1, {1, 1, 1}));
  const double pi = std::acos(-1.0), rate = 6 * pi;
  scene.bodies[0].angular_velocity = {0, 0, rate};
  scene.constraints.push_back(test::joint(ConstraintType::revolute, "hinge",
                                          test::side(scenes::ground, {}, {{0, 0, 1}}, {{1, 0, 0}}),
                                          test::side(0, {}, {{0, 0, 1}}, {{1, 0, 0}})));
  scenes::TorsionalSpringDamper spring;
  spring.joint = 0;
  spring.stiffness = 1;
  scene.effects.emplace_back(spring);
  SimulationOptions options = tight(GetParam(), "rkf78", 5, 1e-11);
  options.output_step = 0.25;
  const Motion motion(scene, options);
  for (const MotionSample& s : motion.samples)
    EXPECT_NEAR(s.state.twist[0].omega_bar[2], rate * std::cos(s.state.t), 1e-8) << s.state.t;
  EXPECT_LE(motion.report.unaccounted_energy, 1e-8 * motion.report.energy_start);
}

// hung straight below, the bob is struck through its hook: 1 m/s = J (1/m + l^2/I)
TEST_P(InEveryFormulation, ADriverWhoseSpeedJumpsStrikesWithAnImpulse) {
  const scenes::Scene scene = catalogue_scene("wellformed/jerked_trolley");
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
  EXPECT_NEAR(struck.report.impulses[0].lambda[5], -impulse, 1e-11);  // after the rail's five rows
  EXPECT_NEAR(after.energy - struck.samples[0].energy, impulse * (0.4 + 1.4) / 2, 1e-11);
  EXPECT_LE(struck.report.unaccounted_energy, 1e-10);
}

// the state after it is that of the end
TEST_P(InEveryFormulation, AJumpAtTheEndOfTheRunIsStillPassed) {
  for (const char* method :
       {"dopri5", "cvode-bdf", "ida", "radau5", "radau9", "hedop5", "generalized-alpha", "bdf"}) {
    SimulationOptions options = tight(GetParam(), method, 0.5, 1e-9);
    if (!integrators::find_method(method)->chooses_steps) options.step = 0.001;
    const Motion motion(catalogue_scene("wellformed/jerked_trolley"), options);
    ASSERT_EQ(motion.report.impulses.size(), 1u) << method;
    EXPECT_NEAR(motion.end().state.twist[0].r_dot[0], 1.4, 1e-9) << method;
  }
}

TEST_P(InEveryFormulation, EveryMethodGoesOverAJumpOfVelocities) {
  const scenes::Scene scene = catalogue_scene("wellformed/jerked_trolley");
  const Motion exact(scene, tight("r-omega", "rkf78", 1, 1e-12));
  ASSERT_EQ(exact.report.impulses.size(), 2u);
  for (const char* method : {"dopri5", "bulirsch-stoer", "abm", "cvode-adams", "cvode-bdf", "arkode-erk",
                             "arkode-dirk", "ida", "radau5", "radau9", "generalized-alpha",
                             "generalized-alpha-gl2", "bdf", "hem4", "hedop5", "rattle", "rattle4"}) {
    if (std::string(method).starts_with("rattle") && !inertia_is_constant(GetParam())) continue;
    SimulationOptions options = tight(GetParam(), method, 1, 1e-9);
    const bool steps = !integrators::find_method(method)->chooses_steps;
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
    // at the event the method's own multipliers are those of before it
    EXPECT_LE(motion.report.lambda_gap, steps ? 1e-2 : 1e-5) << method;
  }
}

// a micrometre long, it moves as one of a metre: rows of angles are not judged by lengths
TEST_P(InEveryFormulation, TheSizeOfAMechanismChangesNothing) {
  const auto scaled = [](double size) {
    scenes::Scene scene = scenes::two_bars();
    const auto scale = [](scenes::Vector3& v, double by) {
      for (double& x : v) x *= by;
    };
    for (scenes::Body& body : scene.bodies) {
      scale(std::get<scenes::Vector3>(body.inertia), size * size);
      scale(body.position, size);
      scale(body.velocity, size);
    }
    for (scenes::Constraint& joint : scene.constraints)
      for (scenes::Side* side : {&joint.i, &joint.j})
        if (side->point) scale(*side->point, size);
    scale(std::get<scenes::Gravity>(scene.effects.front()).acceleration, size);
    return scene;
  };
  constexpr double size = 1e-6;
  for (const integrators::MethodInfo& method : integrators::methods()) {
    const std::string name(method.name);
    if (!method.takes_given_steps || (name.starts_with("rattle") && !inertia_is_constant(GetParam())))
      continue;
    SimulationOptions options = tight(GetParam(), name, 0.5);
    options.step = 1e-3;
    const Motion small(scaled(size), options), large(scaled(1), options);
    for (int b = 0; b < 2; ++b)
      EXPECT_LE((small.end().state.pose[b].r / size - large.end().state.pose[b].r).norm(), 1e-8)
          << name << " " << b;
  }
}

// order 4 has parts that go back: none may see what is beyond an event
TEST(Rattle, KeepsItsOrderOverEvents) {
  const scenes::Scene scene = catalogue_scene("wellformed/jerked_trolley");
  const Motion exact(scene, tight("r-omega", "rkf78", 1, 1e-13));
  const auto error = [&](double h) {
    SimulationOptions options = tight("r-omega", "rattle4", 1);
    options.step = h;
    const Motion motion(scene, options);
    EXPECT_LE(motion.report.unaccounted_energy, 1e-3 * h);
    return (motion.end().state.pose[1].r - exact.end().state.pose[1].r).norm();
  };
  const double coarse = error(0.05), fine = error(0.025);
  EXPECT_NEAR(std::log2(coarse / fine), 4, 0.5);
}

TEST(Rattle, WorkIsOfTheMethodsOrder) {
  const auto missing = [&](const char* method, double h) {
    SimulationOptions options = tight("r-omega", method, 1);
    options.step = h;
    return Motion(catalogue_scene("driven_crank"), options).report.unaccounted_energy;
  };
  EXPECT_NEAR(std::log2(missing("rattle", 0.01) / missing("rattle", 0.005)), 2, 0.2);
  EXPECT_NEAR(std::log2(missing("rattle4", 0.01) / missing("rattle4", 0.005)), 4, 0.2);
}

// a wheel that winds a weak spring up moves nearly evenly, so that errors alone would let steps be many turns
TEST_P(InEveryFormulation, NoStepLosesCountOfTheTurns) {
  const scenes::Scene scene = test::sprung_wheel(0.5, 20, 0.2, 0);
  for (const char* method : {"dopri5", "rkf78", "bulirsch-stoer", "abm", "cvode-adams", "arkode-erk"}) {
    const Motion motion(scene, tight(GetParam(), method, 5, 1e-6));
    EXPECT_NEAR(motion.end().state.twist[0].omega_bar[2], 20 * std::cos(5 * std::sqrt(0.4)), 1e-3) << method;
    // Adams' errors add up over many short steps
    EXPECT_LE(motion.report.unaccounted_energy, method == std::string("cvode-adams") ? 2e-2 : 1e-3) << method;
  }
}

// rounding of a body far away or fast is none of the others'
TEST_P(InEveryFormulation, AnotherBodySpoilsNoSingularPosition) {
  const Reference exact(TRIVIUM_REFERENCE_DIR, "n_four_bar_1");
  scenes::Scene scene = catalogue_scene("n_four_bar_1");
  scene.bodies.push_back(test::body("stone", 1e-3, {1, 1, 1}, {1000, 0, 0}));
  scene.bodies.back().velocity = {300, 0, 0};
  scene.bodies.back().angular_velocity = {1, 0, 0};
  const Motion motion(scene, tight(GetParam(), "dopri5", 10, 1e-10));
  const auto& r = motion.end().state.pose[2].r;
  EXPECT_LE(std::hypot(r[0] - 0.5 - exact["x"].back(), r[1] - exact["y"].back()), 1e-6);
}

// the quintic's own pieces are integrated exactly by order 8, but not across their kinks
TEST_P(InEveryFormulation, KinksOfAFunctionOfTimeAreLandedOn) {
  scenes::Scene scene;
  scene.name = "pushed";
  scene.bodies.push_back(test::body("puck", 1, {1, 1, 1}));
  scenes::Force push;
  push.body = 0;
  push.force[0] = TimeFunction::Step5{0.13, 0, 0.77, 1};
  scene.effects.emplace_back(push);
  SimulationOptions options;
  options.formulation = GetParam();
  options.integrator = "rkf78";
  options.end = 1;
  options.step = 0.25;
  EXPECT_NEAR(Motion(scene, options).end().state.twist[0].r_dot[0], (0.77 - 0.13) / 2 + (1 - 0.77), 1e-14);
}

TEST_P(InEveryFormulation, DriftStaysWhereProjectionIsOffAndIsReported) {
  SimulationOptions options = tight(GetParam(), "dopri5", 5, 1e-6);
  const Motion projected(catalogue_scene("heavy_top"), options);
  EXPECT_LE(projected.report.phi, 1e-13);
  options.projects = false;
  const Motion drifting(catalogue_scene("heavy_top"), options);
  EXPECT_GT(drifting.report.phi, 1e-6);
  options.baumgarte = {30, 30};
  const Motion stabilised(catalogue_scene("heavy_top"), options);
  EXPECT_LT(stabilised.report.phi, drifting.report.phi / 10);
}

// off the constraints redundant rows look independent; how many are redundant does not change
TEST_P(InEveryFormulation, DriftMakesNoRedundantRowIndependent) {
  // the parallelogram until shortly before it lies flat
  for (const auto& [name, end] : {std::pair("parallelogram", 1.525), {"bricard", 5}, {"four_bar", 5}}) {
    SimulationOptions options = tight(GetParam(), "dopri5", end, 1e-6);
    options.projects = false;
    const Motion motion(catalogue_scene(name), options);
    EXPECT_LE(motion.report.unaccounted_energy, 0.01) << name;
    EXPECT_TRUE(motion.report.passages.empty());
  }
}

TEST(TheRawChart, IsAnErrorThatNamesTheBodyWhereItIsSingular) {
  SimulationOptions options = tight("r-epsilon", "dopri5", 5, 1e-9);
  options.charts = {*parse_euler_sequence("313"), false};
  try {
    const Motion motion(catalogue_scene("heavy_top"), options);  // starts upright
    FAIL() << "reached " << motion.report.reached;
  } catch (const ModelError& error) {
    EXPECT_NE(std::string(error.what()).find("body \"top\""), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("re-framing"), std::string::npos) << error.what();
  }
  options.charts.reframe = true;
  const Motion motion(catalogue_scene("heavy_top"), options);
  EXPECT_TRUE(motion.report.complete);
  EXPECT_GT(motion.report.reframings, 0);
}

TEST(Simulation, InQuadGoesBeyondDouble) {
  const Reference exact(TRIVIUM_REFERENCE_DIR, "spatial_slider_crank");
  const Motion motion(catalogue_scene("spatial_slider_crank"), tight("r-p", "rkf78", 0.5, 1e-17), in_quad);
  EXPECT_NEAR(motion.end().state.pose[2].r[0], exact["slider_x"][5], 4e-16);
  EXPECT_LE(motion.report.phi, 1e-30);
}

}  // namespace
}  // namespace trivium
