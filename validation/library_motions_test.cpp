/// Simulations by the methods of SUNDIALS, in every formulation.

#include <algorithm>
#include <cmath>

#include "base/raise.hpp"
#include "scenes/testing/scene_builders.hpp"
#include "validation/testing/catalogue_motion.hpp"

namespace trivium {
namespace {

using test::apart, test::catalogue_scene, test::Implicit, test::InEveryFormulation, test::Motion, test::tight;

class Libraries : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Motions, Libraries, testing::ValuesIn(formulation_names()),
                         test::formulation_in_a_name);

const std::vector<std::string> of_sundials{"cvode-adams", "cvode-bdf", "arkode-erk", "arkode-dirk", "ida"};

TEST_P(Implicit, BackwardDifferencesOfLibrariesChooseLongStepsInAStiffMotion) {
  static const Motion exact(catalogue_scene("flyball_governor"), tight("r-omega", "rkf78", 1, 1e-11));
  const Motion by_dopri5(catalogue_scene("flyball_governor"), tight(GetParam(), "dopri5", 1, 1e-7));
  for (const char* method : {"cvode-bdf", "ida", "arkode-dirk"}) {
    const Motion motion(catalogue_scene("flyball_governor"), tight(GetParam(), method, 1, 1e-7));
    EXPECT_LE(apart(motion, exact), 5e-5) << method;
    EXPECT_LE(motion.report.counters.steps + motion.report.counters.rejected_steps,
              by_dopri5.report.counters.steps / 2)
        << method;
    // A poor Newton matrix would need more iterations.
    EXPECT_LE(static_cast<double>(motion.report.counters.iterations),
              method == std::string("arkode-dirk") ? 45.0 * static_cast<double>(motion.report.counters.steps)
                                                   : 5.0 * static_cast<double>(motion.report.counters.steps))
        << method;
  }
}

// A matrix of another step size must not damp the stages of arkode-dirk.
TEST_P(InEveryFormulation, UndampedVibrationsKeepTheirAmplitude) {
  scenes::Scene scene;
  scene.name = "stone";
  scene.bodies = {test::body("stone", 1, {0.1, 0.1, 0.1}, {1, 0, 0})};
  SpringDamper<double> spring;
  spring.i = {scenes::ground, Vector3<double>::Zero()};
  spring.j = {0, Vector3<double>::Zero()};
  spring.stiffness = 100;
  spring.free_length = 0.95;
  scene.effects.emplace_back(spring);
  for (const std::string& method : of_sundials) {
    const Motion motion(scene, tight(GetParam(), method, 20, 1e-8));
    EXPECT_NEAR(motion.end().state.pose[0].r[0], 0.95 + 0.05 * std::cos(10 * 20.0), 1e-5) << method;
  }
}

// The tolerance of numbers that pass zero must not fall below the rounding of the others.
TEST_P(InEveryFormulation, IdaFollowsABillionTimesTheGravityOnTheSamePath) {
  scenes::Scene scene = catalogue_scene("four_bar");
  constexpr double gravity = 1e9, end = 3;
  const Motion exact(scene, tight("r-omega", "rkf78", end, 1e-12));
  const double speed = std::sqrt(gravity);
  for (scenes::Body& body : scene.bodies)
    for (int k = 0; k < 3; ++k) {
      body.velocity[k] *= speed;
      body.angular_velocity[k] *= speed;
    }
  for (double& g : std::get<Gravity<double>>(scene.effects[0]).acceleration) g *= gravity;
  const Motion motion(scene, tight(GetParam(), "ida", end / speed, 1e-8));
  EXPECT_LE(apart(motion, exact), 1e-3);
}

// In a short step the rounding of a heavy body's momentum is a large part of a light body's multiplier.
TEST_P(InEveryFormulation, IdaStartsLightBodiesBesideHeavyOnes) {
  const scenes::Scene scene = test::hard_scene("ill_scaled");
  const Motion exact(scene, tight("r-omega", "rkf78", 0.3, 1e-11));
  EXPECT_LE(apart(Motion(scene, tight(GetParam(), "ida", 0.3, 1e-8)), exact), 1e-4);
}

TEST_P(Libraries, MotionsFollowTheToleranceOnTheirConstraints) {
  for (const auto& [name, end] : {std::pair("spatial_slider_crank", 0.5),
                                  {"bricard", 2.0},
                                  {"stewart_platform", 0.5},
                                  {"welded_rotor", 1.0}}) {
    const Motion exact(catalogue_scene(name), tight("r-omega", "rkf78", end, 1e-12));
    for (const std::string& method : of_sundials) {
      double before = 1;
      for (const double rtol : {1e-5, 1e-9}) {
        const Motion motion(catalogue_scene(name), tight(GetParam(), method, end, rtol));
        EXPECT_LE(apart(motion, exact), 1e3 * rtol) << name << " " << method;
        EXPECT_LE(apart(motion, exact), before) << name << " " << method;
        EXPECT_LE(motion.report.phi, 1e-13) << name << " " << method;
        EXPECT_LE(motion.report.phi_dot, 1e-12) << name << " " << method;
        EXPECT_LE(motion.report.normalisation, 1e-14) << name << " " << method;
        before = apart(motion, exact) / 10;
      }
    }
  }
}

// These methods interpolate at outputs: outputs cost no steps, and are as accurate as the end of the run.
TEST_P(Libraries, OutputsBetweenStepsAreOfTheMethodsOwnAccuracy) {
  SimulationOptions options = tight("r-omega", "rkf78", 1, 1e-12);
  options.output_step = 0.01;
  const Motion exact(catalogue_scene("double_pendulum"), options);
  for (const char* method : {"cvode-adams", "cvode-bdf", "ida"}) {
    options = tight(GetParam(), method, 1, 1e-8);
    const Motion alone(catalogue_scene("double_pendulum"), options);
    options.output_step = 0.01;
    const Motion motion(catalogue_scene("double_pendulum"), options);
    ASSERT_EQ(motion.samples.size(), exact.samples.size());
    double largest = 0;
    for (std::size_t k = 0; k < exact.samples.size(); ++k) {
      EXPECT_EQ(motion.samples[k].state.t, exact.samples[k].state.t);
      EXPECT_LE(motion.samples[k].phi, 1e-13) << method << " " << k;
      for (std::size_t b = 0; b < 2; ++b)
        raise(largest, (motion.samples[k].state.pose[b].r - exact.samples[k].state.pose[b].r).norm());
    }
    EXPECT_LE(largest, 1e-6) << method;
    EXPECT_EQ(motion.report.counters.steps, alone.report.counters.steps) << method;
  }
}

TEST_P(Libraries, MultipliersOfIDAAreThoseOfTheState) {
  SimulationOptions options = tight(GetParam(), "ida", 0.5, 1e-9);
  options.output_step = 0.05;
  const Motion motion(catalogue_scene("spatial_slider_crank"), options);
  double largest = 0;
  for (const MotionSample& sample : motion.samples)
    raise(largest, sample.lambda.size() ? sample.lambda.cwiseAbs().maxCoeff() : 0.0);
  EXPECT_LE(motion.report.lambda_gap, 1e-4 * largest);
}

TEST(LibrariesUnprojected, DriftAsTheTolerancesLetThem) {
  for (const char* method : {"cvode-adams", "cvode-bdf", "arkode-erk", "arkode-dirk"}) {
    SimulationOptions options = tight("r-p", method, 2, 1e-6);
    options.projects = false;
    const Motion motion(catalogue_scene("double_pendulum"), options);
    EXPECT_GE(motion.report.phi, 1e-10) << method;
    EXPECT_LE(motion.report.phi, 1e-3) << method;
  }
}

}  // namespace
}  // namespace trivium
