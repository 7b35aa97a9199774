/// Motions through the public interface: observers, the end of a run and its continuation, and the comparison
/// of lambda in several formulations.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "integrators/methods.hpp"
#include "scenes/testing/scene_builders.hpp"
#include "simulation/simulate.hpp"
#include "trivium/testing/front_door_scenes.hpp"
#include "trivium/trivium.hpp"

namespace trivium {
namespace {

namespace fs = std::filesystem;

using test::path_of, test::scene_of, test::temporary;

/// All numbers of an output. p and -p are the same orientation; the one with e0 >= 0 is taken.
std::vector<double> numbers_of(const Output& at) {
  std::vector<double> all{at.t, at.energy, at.phi, at.phi_dot};
  for (const BodyInstant& body : at.bodies) {
    const double sign = std::signbit(body.p[0]) ? -1 : 1;
    for (const auto& v : {body.r, body.r_dot, body.r_ddot, body.omega_bar, body.omega_bar_dot})
      all.insert(all.end(), v.begin(), v.end());
    for (const double e : body.p) all.push_back(sign * e);
  }
  all.insert(all.end(), at.lambda.begin(), at.lambda.end());
  all.insert(all.end(), at.raw_lambda.begin(), at.raw_lambda.end());
  return all;
}

/// The largest difference of a component of r [m] or r_dot [m/s].
double apart(const Output& a, const Output& b) {
  double largest = 0;
  for (std::size_t n = 0; n < a.bodies.size(); ++n)
    for (std::size_t x = 0; x < 3; ++x) {
      largest = std::max(largest, std::abs(a.bodies[n].r[x] - b.bodies[n].r[x]));
      largest = std::max(largest, std::abs(a.bodies[n].r_dot[x] - b.bodies[n].r_dot[x]));
    }
  return largest;
}

bool keeps_more_than_a_step(std::string_view method) { return method == "abm" || method == "bdf"; }

/// Interrupts a run with given steps in the middle, continues it from a file, and compares the end with that
/// of the whole run, for every method and formulation. One-step methods must agree in every bit.
void expect_to_go_on(const Scene& scene, double step, int steps) {
  for (const integrators::MethodInfo& method : integrators::methods())
    for (const std::string& formulation : formulation_names()) {
      if (!method.takes_given_steps || !goes_with(method, formulation)) continue;
      SimulateSettings settings;
      settings.formulation = formulation;
      settings.integrator = method.name;
      settings.step = step;
      settings.end = steps * step;
      const Motion whole = simulate(scene, settings);
      SimulateSettings half = settings;
      half.end = (steps / 2) * step;
      const fs::path file = temporary("json");
      simulate(scene, half).end.write(file);
      const Motion rest = simulate(read_scene(file), settings);
      if (keeps_more_than_a_step(method.name))
        EXPECT_LE(apart(rest.outputs.back(), whole.outputs.back()), 1e-3)
            << method.name << " " << formulation;
      else
        EXPECT_EQ(numbers_of(rest.outputs.back()), numbers_of(whole.outputs.back()))
            << method.name << " " << formulation;
    }
}

TEST(FrontDoorMotions, GoOnFromAFileToTheSameBits) {
  expect_to_go_on(read_scene(path_of("spatial_slider_crank")), 0.002, 12);
}

TEST(FrontDoorMotions, GoOnToTheSameBitsWhereRowsAreRedundant) {
  expect_to_go_on(read_scene(path_of("four_bar")), 0.002, 8);
}

TEST(FrontDoorMotions, GoOnToTheSameBitsInOtherCharts) {
  expect_to_go_on(read_scene(path_of("heavy_top")), 0.0005, 30);
}

// the driver's function has a kink at t0 = 0.02, which is also the end of the first run
TEST(FrontDoorMotions, GoOnToTheSameBitsBesideAnEvent) {
  Scene scene("driven arm");
  scene.add_body({.name = "arm", .mass = 2, .inertia = {0.1, 0.2, 0.15}, .position = {0.5, 0, 0}});
  scene.add_body({.name = "bob", .mass = 1, .inertia = {0.1, 0.1, 0.1}, .position = {1, 0, -0.5}});
  scene.add_constraint("revolute", "hinge", {.body = "ground", .axis = {0, 0, 1}, .x = {1, 0, 0}},
                       {.body = "arm", .point = {-0.5, 0, 0}, .axis = {0, 0, 1}, .x = {1, 0, 0}});
  scene.add_constraint("rotation_driver", "drive", {.body = "ground", .axis = {0, 0, 1}, .x = {1, 0, 0}},
                       {.body = "arm", .axis = {0, 0, 1}, .x = {1, 0, 0}},
                       {{"angle", {{"kind", "step5"}, {"t0", 0.02}, {"f0", 0}, {"t1", 0.3}, {"f1", 1}}}});
  scene.add_constraint("spherical", "pin", {.body = "arm", .point = {0.5, 0, 0}},
                       {.body = "bob", .point = {0, 0, 0.5}});
  scene.add_effect("gravity", {{"acceleration", {0, 1, -9.81}}});
  expect_to_go_on(scene, 0.002, 20);
  expect_to_go_on(read_scene(path_of("basic_drivers")), 0.001, 8);
}

TEST(FrontDoorMotions, CountTheTurnsOfASpringOn) {
  // at 30 rad/s the spring is wound by several full turns when the first run ends
  const Scene wheel = scene_of(test::sprung_wheel(1, 30, 0.5, 0.01));
  const Motion first = simulate(wheel, {.end = 1});
  const Motion rest = simulate(first.end, {.end = 2}), whole = simulate(wheel, {.end = 2});
  EXPECT_NEAR(rest.outputs.back().energy, whole.outputs.back().energy, 1e-6);
  // another formulation cannot use the saved state vector: it starts from the bodies and turns in the file
  const fs::path file = temporary("json");
  first.end.write(file);
  const Motion other = simulate(read_scene(file), {.formulation = "r-p", .end = 2});
  EXPECT_NEAR(other.outputs.back().energy, whole.outputs.back().energy, 1e-6);
  expect_to_go_on(wheel, 0.01, 60);
}

TEST(FrontDoorMotions, CountEnergyAndWorkFromTheirOwnStart) {
  for (const char* name : {"driven_crank", "universal_shaft_line", "basic_drivers"}) {
    const Motion first = simulate(read_scene(path_of(name)), {.end = 0.5});
    const Motion rest = simulate(first.end, {.end = 1});
    EXPECT_LE(rest.unaccounted_energy, 1e-6) << name;
    EXPECT_NEAR(rest.work, rest.energy_end - rest.energy_start, 1e-6) << name;
    EXPECT_TRUE(rest.warnings.empty()) << name << ": " << rest.warnings.front();
  }
}

TEST(FrontDoorMotions, GoOnWithinTheirTolerancesWhereStepsAreChosen) {
  const Scene scene = read_scene(path_of("spatial_slider_crank"));
  for (const integrators::MethodInfo& method : integrators::methods()) {
    if (!method.chooses_steps) continue;
    SimulateSettings settings;
    settings.integrator = method.name;
    settings.end = 1;
    const Motion whole = simulate(scene, settings);
    settings.end = 0.4;
    const Motion first = simulate(scene, settings);
    settings.end = 1;
    EXPECT_LE(apart(simulate(first.end, settings).outputs.back(), whole.outputs.back()), 1e-4) << method.name;
  }
}

TEST(FrontDoorMotions, AreStoppedFromTheObserverAtAnOutput) {
  const Scene scene = read_scene(path_of("heavy_top"));
  int seen = 0;
  const Motion motion =
      simulate(scene, {.end = 1, .output_step = 0.125}, [&](const Output& at) { return ++seen, at.t < 0.5; });
  EXPECT_EQ(seen, 5);
  EXPECT_EQ(motion.reached, 0.5);
  EXPECT_FALSE(motion.complete);
  EXPECT_EQ(motion.end.t(), 0.5);
  const Motion rest = simulate(motion.end, {.end = 1, .output_step = 0.125});
  EXPECT_EQ(rest.outputs.front().t, 0.5);
  EXPECT_EQ(rest.outputs.size(), 5u);
  EXPECT_TRUE(rest.complete);
}

TEST(FrontDoorMotions, AreStoppedAfterAStep) {
  int steps = 0;
  const Motion motion =
      simulate(read_scene(path_of("heavy_top")), {.end = 1, .at_step = [&](double) { return ++steps < 7; }});
  EXPECT_EQ(motion.steps, 7);
  EXPECT_FALSE(motion.complete);
}

TEST(FrontDoorMotions, AnObserversOwnExceptionComesThrough) {
  struct Mine {};
  EXPECT_THROW(
      simulate(read_scene(path_of("heavy_top")), {.end = 1}, [](const Output&) -> bool { throw Mine{}; }),
      Mine);
}

TEST(FrontDoorMotions, ABodyThatWasMovedByHandIsNotGoneOnWith) {
  Motion motion = simulate(read_scene(path_of("asymmetric_free_body")), {.end = 0.1});
  auto edited = std::make_shared<Scene::Contents>(motion.end.contents());
  edited->scene.bodies[0].angular_velocity[2] += 1e-9;
  const Scene moved{std::shared_ptr<const Scene::Contents>(edited)};
  try {
    simulate(moved, {.end = 1});
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_NE(std::string(error.what()).find("body \""), std::string::npos) << error.what();
  }
  edited->scene.saved.reset();
  EXPECT_TRUE(simulate(moved, {.end = 0.2}).complete);
}

TEST(FrontDoorMotions, APointOfABodyMovesAsItsVelocityAndAccelerationSay) {
  constexpr double h = 1e-4;
  for (const std::string& formulation : formulation_names()) {
    const Motion motion = simulate(read_scene(path_of("spatial_slider_crank")), {.formulation = formulation,
                                                                                 .integrator = "rkf78",
                                                                                 .end = 40 * h,
                                                                                 .output_step = h,
                                                                                 .rtol = 1e-13,
                                                                                 .atol = 1e-14});
    for (std::size_t k = 1; k + 1 < motion.outputs.size(); ++k) {
      const auto at = [&](std::size_t n) { return motion.outputs[n].point("rod", {0.1, -0.2, 0.3}); };
      const PointMotion before = at(k - 1), now = at(k), after = at(k + 1);
      for (std::size_t x = 0; x < 3; ++x) {
        EXPECT_NEAR(now.velocity[x], (after.position[x] - before.position[x]) / (2 * h), 1e-4);
        EXPECT_NEAR(now.acceleration[x], (after.velocity[x] - before.velocity[x]) / (2 * h), 1e-3);
      }
    }
  }
}

TEST(FrontDoorMotions, SayOfEveryOutputWhichMultipliersAreUniqueAndHowGoodTheyAre) {
  const Scene scene = read_scene(path_of("bricard")), unique = read_scene(path_of("heavy_top"));
  const Solution at = solve(scene);
  for (const Output& now : simulate(scene, {.end = 0.1, .output_step = 0.02}).outputs)
    EXPECT_EQ(now.lambda_is_unique, at.lambda_is_unique) << now.t;
  for (const Output& now : simulate(unique, {.formulation = "r-epsilon", .end = 0.1}).outputs) {
    EXPECT_EQ(now.lambda_is_unique, std::vector<bool>(3, true));
    EXPECT_EQ(now.charts.size(), 1u);
    EXPECT_LE(now.lambda_error, 1e-10);
    EXPECT_LE(now.acceleration_error, 1e-10);
  }
}

TEST(FrontDoorMotions, SayWhatDeservesAWarning) {
  const Motion drifting = simulate(read_scene(path_of("spatial_slider_crank")),
                                   {.integrator = "dopri5", .end = 2, .step = 0.01, .projects = false});
  ASSERT_FALSE(drifting.warnings.empty());
  EXPECT_NE(drifting.warnings.back().find("constraints are violated"), std::string::npos);
}

TEST(FrontDoorMotions, CompareLambdaInEveryFormulation) {
  const ComparedMotions all =
      compare(read_scene(path_of("spatial_slider_crank")), {.run = {.end = 1}, .states = 5});
  EXPECT_EQ(all.motions.size(), formulation_names().size());
  EXPECT_EQ(all.outputs.size(), 101u);
  EXPECT_TRUE(all.complete && all.has_unique_lambda && all.holds_along && all.holds_at_states);
  EXPECT_EQ(std::count_if(all.outputs.begin(), all.outputs.end(),
                          [](const ComparedOutput& at) { return at.one_state.has_value(); }),
            5);
  EXPECT_GT(all.outputs.back().lambda_difference, 0);
  EXPECT_LT(all.outputs.back().lambda_bound, 1e-2);
}

}  // namespace
}  // namespace trivium
