/// Simulations by the Radau IIA methods, which choose long steps in stiff motions.

#include <array>
#include <cmath>
#include <utility>

#include "scenes/testing/scene_builders.hpp"
#include "validation/testing/catalogue_motion.hpp"

namespace trivium {
namespace {

using test::apart, test::catalogue_scene, test::in_quad, test::Implicit, test::Motion, test::stepping,
    test::tight;

// The step sizes are chosen by the method: there must be few steps compared with an explicit method, although
// the springs turn by a third of a radian in one step.
TEST_P(Implicit, RadauChoosesLongStepsInAStiffMotion) {
  static const Motion exact(catalogue_scene("flyball_governor"), tight("r-omega", "rkf78", 1, 1e-11));
  const Motion motion(catalogue_scene("flyball_governor"), tight(GetParam(), "radau5", 1, 1e-6));
  const Motion by_dopri5(catalogue_scene("flyball_governor"), tight(GetParam(), "dopri5", 1, 1e-6));
  EXPECT_LE(apart(motion, exact), 1e-5);
  EXPECT_LE(motion.report.counters.steps + motion.report.counters.rejected_steps,
            by_dopri5.report.counters.steps / 30);
  EXPECT_LE(motion.report.counters.rejected_steps, motion.report.counters.steps / 4);
  EXPECT_LE(motion.report.counters.iterations, 8 * motion.report.counters.steps);
}

// Tolerance weights must not grow with the distance from the origin: the steps are those of the same pendulum
// at the origin.
TEST_P(Implicit, RadauIsAsAccurateFarFromTheOrigin) {
  const auto pendulum_at = [](double x) {
    scenes::Scene scene;
    scene.name = "pendulum";
    scene.bodies.push_back(test::body("bob", 1, {0.1, 0.2, 0.25}, {x + 1, 0, 0}));
    scene.constraints.push_back(test::joint(JointType::revolute, "pivot",
                                            test::side(scenes::ground, {{x, 0, 0}}, {{0, 1, 0}}),
                                            test::side(0, {{-1, 0, 0}}, {{0, 1, 0}})));
    scene.effects.push_back(test::gravity());
    return scene;
  };
  const Motion exact(pendulum_at(0), tight("r-omega", "rkf78", 3, 1e-12));
  for (const double rtol : {1e-3, 1e-6}) {
    const Motion near(pendulum_at(0), tight(GetParam(), "radau5", 3, rtol)),
        far(pendulum_at(1e5), tight(GetParam(), "radau5", 3, rtol));
    const auto off = [&](const Motion& motion, double x) {
      const auto &r = motion.end().state.pose[0].r, &there = exact.end().state.pose[0].r;
      return std::hypot(r[0] - x - there[0], r[2] - there[2]);
    };
    EXPECT_LE(off(far, 1e5), 2 * off(near, 0)) << rtol;
    EXPECT_LE(off(near, 0), 10 * rtol) << rtol;
    const auto tried = [](const Motion& motion) {
      const auto& counters = motion.report.counters;
      return static_cast<double>(counters.steps + counters.rejected_steps);
    };
    EXPECT_NEAR(tried(far), tried(near), 0.1 * tried(near)) << rtol;
  }
}

// The Newton matrix of a stage's first iterate serves for the whole iteration, also where masses differ much.
TEST_P(Implicit, RadauErrsByAFewTolerancesHoweverMassesDiffer) {
  const scenes::Vector3 z{0, 0, 1};
  for (const auto& [upper, lower] : {std::pair(1e6, 1.0), {1.0, 1e6}, {1e6, 1e-6}, {1e-6, 1e6}}) {
    scenes::Scene scene;
    scene.bodies = {test::body("a", upper, {0.1 * upper, 0.1 * upper, 0.1 * upper}, {0.5, 0, 0}),
                    test::body("b", lower, {0.1 * lower, 0.1 * lower, 0.1 * lower}, {1.5, 0, 0})};
    scene.constraints = {
        test::joint(JointType::revolute, "A", test::side(scenes::ground, scenes::Vector3{}, z),
                    test::side(0, scenes::Vector3{-0.5, 0, 0}, z)),
        test::joint(JointType::revolute, "B", test::side(0, scenes::Vector3{0.5, 0, 0}, z),
                    test::side(1, scenes::Vector3{-0.5, 0, 0}, z))};
    scene.effects = {Gravity<double>{"", {0, -9.81, 0}}};
    const Motion exact(scene, tight("r-omega", "rkf78", 2, 1e-12));
    for (const char* method : {"radau5", "radau9"})
      EXPECT_LE(apart(Motion(scene, tight(GetParam(), method, 2, 1e-6)), exact), 5e-6)
          << method << " " << upper << " " << lower;
  }
}

// This must also hold for bodies without constraint rows.
TEST_P(Implicit, RadauKeepsEulerParametersUnit) {
  for (const char* method : {"radau5", "radau9"}) {
    const Motion motion(catalogue_scene("dzhanibekov"), tight(GetParam(), method, 5, 1e-2));
    EXPECT_LE(motion.report.normalisation, 1e-14) << method;
  }
}

// The platform's dampers enter the Newton matrices of the stages, which also give the extra motions sigma_i
// (radau_stages.hpp). The methods must keep their order.
TEST_P(Implicit, RadauIsOfItsOrderWhereDampersAre) {
  const scenes::Scene scene = catalogue_scene("stewart_platform");
  const auto errors = [&](const Motion& motion, const Motion& exact) {
    const auto &a = motion.end(), &b = exact.end();
    const auto apart = [&](const auto& part) {
      double largest = 0;
      for (std::size_t body = 0; body < scene.bodies.size(); ++body)
        raise(largest, ((part(a.state, body) - part(b.state, body)) +
                        (part(*a.state_rest, body) - part(*b.state_rest, body)))
                           .norm());
      return largest;
    };
    return std::array{apart([](const auto& state, std::size_t body) { return state.pose[body].r; }),
                      apart([](const auto& state, std::size_t body) { return state.twist[body].r_dot; }),
                      (a.lambda - b.lambda + a.lambda_rest - b.lambda_rest).norm()};
  };
  struct Case {
    const char* method;
    int order, steps;
    double end;
  };
  for (const Case& c : {Case{"radau5", 5, 10, 0.05}, {"radau9", 9, 5, 0.1}}) {
    const Motion exact(scene, tight("r-omega", "rkf78", c.end, 1e-19), test::in_quad);
    const auto after = [&](int steps) {
      return errors(Motion(scene, stepping(GetParam(), c.method, c.end, c.end / steps), test::in_quad),
                    exact);
    };
    const auto coarse = after(c.steps), fine = after(2 * c.steps);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(std::log2(coarse[k] / fine[k]), c.order, 0.2) << c.method << " " << k;
  }
}

TEST_P(Implicit, RadauMeetsRowsAtTheEndsOfStepsToRounding) {
  for (const char* name : {"flyball_governor", "spatial_slider_crank", "bricard"}) {
    for (const char* method : {"radau5", "radau9"}) {
      const Motion motion(catalogue_scene(name), tight(GetParam(), method, 0.5, 1e-4));
      EXPECT_LE(motion.report.phi, 1e-13) << name << " " << method;
      EXPECT_LE(motion.report.phi_dot, 1e-12) << name << " " << method;
    }
  }
}

// radau9 has five stages in a step but much longer steps, so that it needs fewer evaluations at tight
// tolerances.
TEST_P(Implicit, ToTightErrorsTheHigherOrderOfRadauAsksForLess) {
  static const Motion exact(catalogue_scene("flyball_governor"), tight("r-omega", "rkf78", 1, 1e-13));
  const scenes::Scene scene = catalogue_scene("flyball_governor");
  const Motion by_five(scene, tight(GetParam(), "radau5", 1, 1e-8)),
      by_nine(scene, tight(GetParam(), "radau9", 1, 1e-7));
  EXPECT_LE(apart(by_five, exact), 1e-8);
  EXPECT_LE(apart(by_nine, exact), apart(by_five, exact));
  EXPECT_LE(by_nine.report.counters.right_sides, by_five.report.counters.right_sides / 2);
}

// Modified and full Newton iteration must converge to the same stages, even if the error of the method is
// large.
TEST_P(Implicit, FullNewtonFindsTheSameMotionOfRadauAtLongSteps) {
  SimulationOptions options = stepping(GetParam(), "radau9", 1, 0.025);
  const Motion modified(catalogue_scene("spatial_four_bar"), options);
  options.parameters.full_newton = true;
  EXPECT_LE(apart(Motion(catalogue_scene("spatial_four_bar"), options), modified), 1e-6);
}

// The Newton iteration's remaining error must decrease with the step size: a thousand steps are as accurate
// as a dozen.
TEST_P(Implicit, OutputsThatCutStepsDoNotAddUpToErrorsOfRadau) {
  static const Motion exact(catalogue_scene("stewart_platform"), tight("r-omega", "rkf78", 1, 1e-12));
  for (const char* method : {"radau5", "radau9"}) {
    SimulationOptions options = tight(GetParam(), method, 1, 1e-5);
    const double few = apart(Motion(catalogue_scene("stewart_platform"), options), exact);
    options.output_step = 1e-3;
    EXPECT_LE(apart(Motion(catalogue_scene("stewart_platform"), options), exact), few) << method;
  }
}

}  // namespace
}  // namespace trivium
