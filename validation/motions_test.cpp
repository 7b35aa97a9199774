/// Simulations in every formulation, as by `trivium simulate`, compared with trusted numbers.

#include <cmath>

#include "integrators/methods.hpp"
#include "scenes/generators.hpp"
#include "validation/harness/trusted_numbers.hpp"
#include "validation/testing/catalogue_motion.hpp"

namespace trivium {
namespace {

using test::catalogue_scene, test::in_quad, test::InEveryFormulation, test::Motion, test::tight;

INSTANTIATE_TEST_SUITE_P(Motions, InEveryFormulation, testing::ValuesIn(formulation_names()),
                         test::formulation_in_a_name);

TEST_P(InEveryFormulation, ThePendulumIsThatOfEllipticFunctions) {
  const TrustedNumbers exact(TRIVIUM_REFERENCE_DIR, "a01_pendulum");
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
  const TrustedNumbers exact(TRIVIUM_REFERENCE_DIR, "heavy_top");
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
  const TrustedNumbers exact(TRIVIUM_REFERENCE_DIR, "spatial_slider_crank");
  SimulationOptions options = tight(GetParam(), "rkf78", 5);
  options.output_step = 0.1;
  const Motion motion(catalogue_scene("spatial_slider_crank"), options);
  ASSERT_EQ(motion.samples.size(), exact.rows());
  for (std::size_t k = 0; k < exact.rows(); ++k)
    EXPECT_NEAR(motion.samples[k].state.pose[2].r[0], exact["slider_x"][k], 1e-9) << exact["t"][k];
}

TEST_P(InEveryFormulation, AndrewsSqueezerIsThatOfTheReference) {
  const TrustedNumbers exact(TRIVIUM_REFERENCE_DIR, "andrews_squeezer");
  const Motion motion(catalogue_scene("andrews_squeezer"), tight(GetParam(), "rkf78", 0.03, 1e-13));
  const auto angles = andrews_angles(exact);
  for (std::size_t b = 0; b < angles.size(); ++b)
    EXPECT_LE(apart_from_angle(motion.end().state.pose[b].p, angles[b]), 1e-9) << b;
  // forces of the joints at E on the body that is not K2
  for (const auto& [joint, k] : {std::pair(2, 1), {3, 3}, {4, 5}}) {
    const auto& force = motion.end().reactions[joint].force;
    const double x = exact.value("lambda" + std::to_string(k)),
                 y = exact.value("lambda" + std::to_string(k + 1));
    EXPECT_LE(std::hypot(-force[0] - x, -force[1] - y), 1e-7 * std::hypot(x, y)) << force.transpose();
  }
}

TEST_P(InEveryFormulation, BricardIsThatOfAnotherMethodAtATighterTolerance) {
  static const MotionSample exact =
      Motion(catalogue_scene("bricard"), tight("r-omega", "bulirsch-stoer", 10, 1e-14)).end();
  const Motion motion(catalogue_scene("bricard"), tight(GetParam(), "rkf78", 10));
  for (std::size_t b = 0; b < exact.state.pose.size(); ++b)
    EXPECT_LE((motion.end().state.pose[b].r - exact.state.pose[b].r).norm(), 1e-8);
}

// The orders of r, v and lambda are observed in quad, so that rounding does not hide them.
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

// lambda is the same in all formulations along the whole motion.
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

// A micrometre-sized mechanism moves like one of a metre: tolerances of angles must not depend on lengths.
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
    std::get<Gravity<double>>(scene.effects.front()).acceleration *= size;
    return scene;
  };
  constexpr double size = 1e-6;
  for (const integrators::MethodInfo& method : integrators::methods()) {
    const std::string name(method.name);
    if (!method.takes_given_steps || !goes_with(method, GetParam())) continue;
    SimulationOptions options = tight(GetParam(), name, 0.5);
    options.step = 1e-3;
    const Motion small(scaled(size), options), large(scaled(1), options);
    for (int b = 0; b < 2; ++b)
      EXPECT_LE((small.end().state.pose[b].r / size - large.end().state.pose[b].r).norm(), 1e-8)
          << name << " " << b;
  }
}

TEST(Simulation, InQuadGoesBeyondDouble) {
  const TrustedNumbers exact(TRIVIUM_REFERENCE_DIR, "spatial_slider_crank");
  const Motion motion(catalogue_scene("spatial_slider_crank"), tight("r-p", "rkf78", 0.5, 1e-17), in_quad);
  EXPECT_NEAR(motion.end().state.pose[2].r[0], exact["slider_x"][5], 4e-16);
  EXPECT_LE(motion.report.phi, 1e-30);
}

}  // namespace
}  // namespace trivium
