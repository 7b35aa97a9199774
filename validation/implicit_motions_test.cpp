/// Simulations by implicit methods, in every formulation.

#include <cmath>

#include "scenes/generators.hpp"
#include "scenes/testing/scene_builders.hpp"
#include "validation/testing/catalogue_motion.hpp"

namespace trivium {
namespace {

using test::implicit_methods, test::apart, test::catalogue_scene, test::Implicit, test::Motion,
    test::stepping, test::tight;

INSTANTIATE_TEST_SUITE_P(Motions, Implicit, testing::ValuesIn(formulation_names()),
                         test::formulation_in_a_name);

// The governor's damper limits explicit methods to steps below 1e-3 s.
TEST_P(Implicit, StepsOfAStiffGovernorAreSetByAccuracy) {
  static const Motion exact(catalogue_scene("flyball_governor"), tight("r-omega", "rkf78", 2, 1e-11));
  for (const std::string& method : implicit_methods) {
    const Motion coarse(catalogue_scene("flyball_governor"), stepping(GetParam(), method, 2, 0.01));
    const Motion fine(catalogue_scene("flyball_governor"), stepping(GetParam(), method, 2, 0.005));
    EXPECT_LE(apart(fine, exact), 4e-3) << method;
    EXPECT_GE(apart(coarse, exact), 1.5 * apart(fine, exact)) << method;
    EXPECT_LE(static_cast<double>(fine.report.counters.iterations), 9.0 * 400) << method;  // of 400 steps
  }
  try {
    const Motion explicit_one(catalogue_scene("flyball_governor"), stepping(GetParam(), "dopri5", 2, 0.01));
    EXPECT_GE(apart(explicit_one, exact), 0.1);
  } catch (const std::runtime_error&) {
  }
}

TEST_P(Implicit, PositionsStayOnTheirConstraintsAndVelocitiesToTheMethodsError) {
  for (const char* name : {"spatial_slider_crank", "bricard", "four_bar", "stewart_platform"})
    for (const std::string& method : implicit_methods) {
      const Motion motion(catalogue_scene(name), stepping(GetParam(), method, 0.5, 0.0025));
      EXPECT_LE(motion.report.phi, 1e-12) << name << " " << method;
      const bool is_stabilised = method.ends_with("gl2") || method.starts_with("radau");
      EXPECT_LE(motion.report.phi_dot, is_stabilised ? 1e-10 : 0.2) << name << " " << method;
      if (is_stabilised) continue;
      // The velocity error is an error of the method, not a drift: it decreases at least with order 1.
      const Motion fine(catalogue_scene(name), stepping(GetParam(), method, 0.5, 0.00125));
      EXPECT_LE(fine.report.phi_dot, motion.report.phi_dot / 1.7) << name << " " << method;
    }
}

// The spring forces cancel, so that the sum of forces gives no scale for their rounding errors.
TEST_P(Implicit, ABodyComesToRestOnStiffSpringsAlone) {
  scenes::Scene scene;
  scene.name = "mount";
  scene.bodies.push_back(test::body("block", 1, {0.1, 0.2, 0.15}));
  scene.bodies[0].angular_velocity = {0.1, 0.2, 3};
  scene.effects.emplace_back(Gravity<double>{{}, {0, 0, -9.81}});
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      Vector3<double> on_ground = Vector3<double>::Zero(), on_block = on_ground;
      on_ground[axis] = side;
      on_block[axis] = 0.3 * side;
      on_ground[(axis + 1) % 3] = on_block[(axis + 1) % 3] = 0.1 * side;
      SpringDamper<double> spring;
      spring.i = {scenes::ground, on_ground};
      spring.j = {0, on_block};
      spring.stiffness = 1e8;
      spring.damping = 1e5;
      spring.free_length = 0.7;
      scene.effects.emplace_back(spring);
    }
  for (const char* method : {"generalized-alpha", "hht", "bdf", "radau5", "radau9"}) {
    const Motion motion(scene, stepping(GetParam(), method, 0.5, 1e-3));
    EXPECT_NEAR(motion.end().state.pose[0].r[2], -9.81 / 2e8, 1e-10) << method;
    EXPECT_LE(motion.end().state.twist[0].omega_bar.norm(), 1e-6) << method;
  }
  for (const char* method : {"radau5", "radau9"}) {
    const Motion chosen(scene, tight(GetParam(), method, 0.5, 1e-9));
    EXPECT_NEAR(chosen.end().state.pose[0].r[2], -9.81 / 2e8, 1e-10) << method;
    EXPECT_LE(chosen.report.counters.rejected_steps, chosen.report.counters.steps / 4) << method;
  }
}

// An explicit method would need about 10 000 steps for one of these steps.
TEST_P(Implicit, BackwardDifferencesBeginInAStiffMotionAsTheyGoOn) {
  const scenes::Scene scene = test::sprung_wheel(0.2, 1, 1e6, 1e6);
  for (int order = 1; order <= 5; ++order) {
    auto options = stepping(GetParam(), "bdf", 0.02, 1e-3);
    options.parameters.order = order;
    const Motion motion(scene, options);
    EXPECT_LE(motion.end().state.twist[0].omega_bar.norm(), 1e-6) << order;
    EXPECT_LE(motion.report.counters.right_sides, 200) << order;
  }
}

// With the same method and step size, formulations differ by the error of the method, which decreases with
// its order.
TEST_P(Implicit, LambdaOfTheFormulationsMeetsAtTheMethodsOrder) {
  const auto gap = [&](const std::string& method, double h) {
    const Motion motion(catalogue_scene("spatial_slider_crank"), stepping(GetParam(), method, 0.1, h));
    const Motion by_omega(catalogue_scene("spatial_slider_crank"), stepping("r-omega", method, 0.1, h));
    return (motion.end().lambda - by_omega.end().lambda).norm();
  };
  if (GetParam() == "r-omega") return;
  for (const char* method : {"generalized-alpha", "generalized-alpha-gl2", "hht", "bdf"}) {
    const double coarse = gap(method, 1e-3), fine = gap(method, 2.5e-4);
    EXPECT_LE(coarse, 1e-3) << method;
    EXPECT_LE(fine, coarse / 10 + 1e-10) << method;
  }
}

TEST_P(Implicit, RedundantMechanismsPassTheirSingularPositions) {
  const Motion exact(catalogue_scene("n_four_bar_2"), tight("r-omega", "dopri5", 3, 1e-10));
  for (const char* method : {"generalized-alpha", "bdf"}) {
    const Motion motion(catalogue_scene("n_four_bar_2"), stepping(GetParam(), method, 3, 0.0025));
    EXPECT_LE(apart(motion, exact), 5e-3) << method;
  }
  for (const char* method : {"radau5", "radau9"}) {
    const Motion by_radau(catalogue_scene("n_four_bar_2"), tight(GetParam(), method, 3, 1e-6));
    EXPECT_LE(apart(by_radau, exact), 1e-4) << method;
    EXPECT_LE(by_radau.report.counters.steps, 500) << method;
  }
}

TEST_P(Implicit, ChangesOfChartAndKinksRestartAMethod) {
  const Motion exact(catalogue_scene("heavy_top"), tight("r-omega", "rkf78", 0.3, 1e-11));
  for (const std::string& method : implicit_methods) {
    SimulationOptions options = stepping(GetParam(), method, 0.3, 1e-4);
    options.parameters.order = method == "bdf" ? std::optional<int>(4) : std::nullopt;
    const Motion motion(catalogue_scene("heavy_top"), options);
    EXPECT_LE(apart(motion, exact), 2e-4) << method;
    EXPECT_EQ(motion.report.reframings > 0, motion.report.counters.restarts > 0) << method;
  }
}

TEST_P(Implicit, FullNewtonFindsTheSameMotion) {
  for (const std::string& method : implicit_methods) {
    SimulationOptions options = stepping(GetParam(), method, 0.2, 0.002);
    const Motion modified(catalogue_scene("stewart_platform"), options);
    options.parameters.full_newton = true;
    const Motion full(catalogue_scene("stewart_platform"), options);
    EXPECT_LE(apart(full, modified), 1e-9) << method;
    EXPECT_GE(full.report.factorisations, modified.report.factorisations) << method;
  }
}

// The rounding of positions at 1e9 m is 1e-7 m.
TEST_P(Implicit, AFailingStepFarFromTheOriginNamesTheDistance) {
  scenes::Scene scene = scenes::two_bars();
  for (scenes::Body& one : scene.bodies) one.position[0] += 1e9;
  for (scenes::Constraint& one : scene.constraints)
    for (auto* of : {&one.i, &one.j})
      if (of->body == scenes::ground) of->point = scenes::Vector3{1e9, 0, 0};
  try {
    const Motion motion(scene, stepping(GetParam(), "radau9", 1, 1e-3));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("1.0e+09 m from the global origin"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace trivium
