/// Which motions are warned of, and which are not.

#include "simulation/motion_warnings.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "scenes/make_mechanism.hpp"
#include "scenes/testing/catalogue_scene.hpp"
#include "scenes/testing/scene_builders.hpp"
#include "simulation/simulate.hpp"

namespace trivium {
namespace {

using scenes::Scene, scenes::Vector3;

/// A thin disc on a bar of 1 m, which spins at 1000 rad/s about the bar, tilted by 0.3 rad, with its tip at
/// `tip`.
Scene fast_top(const Vector3& tip = {}) {
  Scene scene;
  const double tilt = 0.3, spin = 1000;
  const Vector3 arm{std::sin(tilt), 0, std::cos(tilt)};
  scene.bodies = {
      test::body("top", 15, {0.234375, 0.234375, 0.46875}, {tip[0] + arm[0], tip[1], tip[2] + arm[2]})};
  scene.bodies[0].orientation = scenes::AxisAngle{{0, 1, 0}, tilt};
  scene.bodies[0].angular_velocity = {spin * arm[0], 0, spin * arm[2]};
  scene.constraints = {test::joint(JointType::spherical, "tip", test::side(scenes::ground, tip),
                                   test::side(0, Vector3{0, 0, -1}))};
  scene.effects = {test::gravity()};
  return scene;
}

/// Adds a body that three pins hold, `distance` away.
Scene with_a_locked_body(Scene scene, double distance) {
  scene.bodies.push_back(test::body("locked", 1, {1, 1, 1}, {distance, 0, 0}));
  const int body = static_cast<int>(scene.bodies.size()) - 1;
  for (const Vector3& pin : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}})
    scene.constraints.push_back(test::joint(
        JointType::spherical, fmt::format("pin {} {}", pin[0], pin[1]),
        test::side(scenes::ground, Vector3{distance + pin[0], pin[1], pin[2]}), test::side(body, pin)));
  return scene;
}

std::vector<std::string> warnings_with(const Scene& scene, const std::string& method, double step, double end,
                                       const std::string& formulation = "r-omega") {
  SimulationOptions options;
  options.integrator = method;
  options.formulation = formulation;
  if (step > 0) options.step = step;
  options.end = end;
  Samples samples;
  return warnings_of(simulate(make_model<double>(scene), options, samples));
}

bool warns(const std::vector<std::string>& warnings, const char* of) {
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const std::string& warning) { return warning.find(of) != std::string::npos; });
}

// Their energies do not show the wrong precession: it is 1e-5 and less of the energy of spin.
TEST(Warnings, NameAFastTopAtGivenSteps) {
  const auto warns_with = [](const char* method, double step) {
    return warns(warnings_with(fast_top(), method, step, 2), "body \"top\": the local errors");
  };
  for (const char* method : {"generalized-alpha", "generalized-alpha-gl2", "hht", "bdf", "rattle"})
    EXPECT_TRUE(warns_with(method, 2e-4)) << method;
  for (const char* method : {"dopri5", "hedop5", "hem4", "abm", "radau5", "rattle4"})
    EXPECT_TRUE(warns_with(method, 1e-3)) << method;
}

TEST(Warnings, DoNotDependOnThePlaceAndOnNeighbours) {
  for (const char* method : {"generalized-alpha", "hht"}) {
    EXPECT_TRUE(warns(warnings_with(fast_top({100, 0, 0}), method, 1e-4, 2), "body \"top\"")) << method;
    EXPECT_TRUE(warns(warnings_with(with_a_locked_body(fast_top(), 1000), method, 1e-4, 2), "body \"top\""))
        << method;
  }
}

TEST(Warnings, AreNotGivenWhereAFreeBodyAtTheOriginTurns) {
  for (const char* method : {"generalized-alpha", "generalized-alpha-gl2", "hht", "bdf", "rattle"})
    EXPECT_EQ(warnings_with(test::catalogue_scene("dzhanibekov"), method, 1e-3, 5),
              std::vector<std::string>{})
        << method;
}

// 1000 N m would turn the body if it were not locked; rounding moves it at 1e-8 m/s
TEST(Warnings, AreNotGivenForALockedBodyUnderALargeLoad) {
  Scene scene = with_a_locked_body({}, 0);
  Torque<double> torque;
  torque.name = "load";
  torque.body = 0;
  torque.components = {0, 0, 1000};
  scene.effects = {torque};
  for (const char* method : {"generalized-alpha", "hht", "bdf", "radau5", "dopri5", "ida"})
    for (const char* formulation : {"r-omega", "r-p", "r-epsilon"})
      EXPECT_EQ(warnings_with(scene, method, 0, 1, formulation), std::vector<std::string>{})
          << method << ", " << formulation;
}

// Gravity and springs cancel but for rounding, which moves the body at 1e-15 m/s.
TEST(Warnings, AreNotGivenForABodyAtRestOnSprings) {
  Scene scene;
  scene.bodies = {test::body("plate", 3, {0.3, 0.3, 0.6})};
  constexpr double stiffness = 30, g = 9.81;
  for (const auto& [x, y] : {std::pair(0.5, 0.0), {-0.25, 0.4}, {-0.25, -0.4}}) {
    SpringDamper<double> spring;
    spring.name = fmt::format("spring {}", scene.effects.size());
    spring.i = {scenes::ground, {x, y, 1}};
    spring.j = {0, {x, y, 0}};
    spring.stiffness = stiffness;
    spring.free_length = 1 - g / stiffness;
    scene.effects.push_back(spring);
  }
  scene.effects.push_back(test::gravity(g));
  for (const char* method : {"generalized-alpha", "radau5", "dopri5", "rattle", "rkf78", "radau9"})
    EXPECT_EQ(warnings_with(scene, method, 0.05, 100), std::vector<std::string>{}) << method;
}

// A load with a jump at every step, such as that of a sampled controller: no two steps have a smooth motion.
// One step is enough for a formula of the accuracy of hht.
TEST(Warnings, SayWhereLocalErrorsAreNotKnown) {
  Scene scene = fast_top();
  TimeFunction::Piecewise sampled;
  for (int n = 0; n <= 500; ++n) {
    if (n > 0) sampled.times.push_back(n * 1e-3);
    sampled.pieces.push_back(TimeFunction(n % 2 == 0 ? 1e-3 : -1e-3));
  }
  Force<double> push;
  push.name = "push";
  push.body = 0;
  push.components[0] = TimeFunction(sampled);
  scene.effects.push_back(push);
  EXPECT_TRUE(warns(warnings_with(scene, "dopri5", 1e-3, 0.5), "local errors of 100 % of the steps are not"));
  EXPECT_FALSE(warns(warnings_with(scene, "hht", 1e-3, 0.5), "of the steps are not known"));
}

}  // namespace
}  // namespace trivium
