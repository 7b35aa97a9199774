/// Chosen steps of methods of low order in all formulations: errors follow the tolerance, and stiff springs
/// do not shorten the steps of implicit methods.

#include <cmath>
#include <string>
#include <vector>

#include "scenes/testing/scene_builders.hpp"
#include "validation/testing/catalogue_motion.hpp"
#include "validation/testing/every_method.hpp"

namespace trivium {
namespace {

using test::catalogue_scene, test::Motion, test::tight;

std::vector<integrators::MethodInfo> methods_of_low_order() {
  std::vector<integrators::MethodInfo> found;
  for (const integrators::MethodInfo& method : integrators::methods())
    if (method.chooses_steps && method.takes_given_steps && method.standard_order <= 4)
      found.push_back(method);
  return found;
}

class LowOrder : public testing::TestWithParam<integrators::MethodInfo> {};

TEST_P(LowOrder, ErrorsAddUpToTheToleranceTimesTheNumberOfSteps) {
  const std::string method(GetParam().name);
  struct Case {
    const char* scene;
    double end;
  };
  for (const Case& c : {Case{"spatial_slider_crank", 0.5}, Case{"andrews_squeezer", 0.02},
                        Case{"heavy_top", 0.2}, Case{"welded_rotor", 0.3}}) {
    const scenes::Scene scene = catalogue_scene(c.scene);
    const Motion exact(scene, tight("r-omega", "rkf78", c.end, 1e-12));
    for (const std::string& formulation : test::formulations_of(GetParam()))
      for (const double rtol : {1e-4, 1e-6}) {
        const Motion motion(scene, tight(formulation, method, c.end, rtol));
        const double steps = static_cast<double>(motion.report.counters.steps);
        // factor 5: the motion amplifies errors
        EXPECT_LE(apart(motion, exact), 5 * rtol * steps) << c.scene << " " << formulation << " " << rtol;
      }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, LowOrder, testing::ValuesIn(methods_of_low_order()),
                         test::method_in_a_name);

// The rows of a driven mechanism determine its motion: all errors lie in the span of the rows' gradients, and
// must limit the steps all the same.
TEST(LowOrder, StepsOfADrivenMechanismFollowTheTolerance) {
  const scenes::Scene scene = catalogue_scene("driven_crank");
  for (const integrators::MethodInfo& method : methods_of_low_order()) {
    const auto steps = [&](double rtol) {
      return Motion(scene, tight("r-omega", std::string(method.name), 2, rtol)).report.counters.steps;
    };
    EXPECT_GE(steps(1e-8), 5 * steps(1e-3)) << method.name;
  }
}

TEST(LowOrder, StepsHardlyDependOnThePlaceOfTheOrigin) {
  for (const integrators::MethodInfo& method : methods_of_low_order()) {
    // a bar that swings about the point with x = distance - 1
    const auto steps = [&](double distance) {
      scenes::Scene scene;
      scene.bodies = {test::body("bar", 2, {0.1, 0.2, 0.2})};
      scene.bodies[0].position = {distance, 0, 0};
      auto pin = test::joint(JointType::spherical, "pin", test::side(scenes::ground, {{distance - 1, 0, 0}}),
                             test::side(0, {{-1, 0, 0}}));
      scene.constraints = {pin};
      scene.effects = {test::gravity()};
      return Motion(scene, tight("r-omega", std::string(method.name), 1, 1e-5)).report.counters.steps;
    };
    EXPECT_LE(steps(0), 1.5 * static_cast<double>(steps(2))) << method.name;
  }
}

TEST(LowOrder, AStiffSpringDoesNotShortenTheStepsOfImplicitMethods) {
  const scenes::Scene scene = catalogue_scene("flyball_governor");
  const long by_stability = Motion(scene, tight("r-omega", "dopri5", 1, 1e-4)).report.counters.steps;
  for (const char* method : {"generalized-alpha", "generalized-alpha-gl2", "hht", "bdf"})
    EXPECT_LE(Motion(scene, tight("r-omega", method, 1, 1e-4)).report.counters.steps, by_stability / 5)
        << method;
}

// With steps of 1e-4 s generalised-alpha ends 0.09 m off, and the energy does not show it.
TEST(LowOrder, AFastTopIsFollowedWhereStepsAreChosen) {
  scenes::Scene scene = catalogue_scene("heavy_top");
  scene.bodies[0].angular_velocity = {0, 0, 1000};
  const Motion exact(scene, tight("r-omega", "rkf78", 0.2, 1e-12));
  for (const char* method : {"generalized-alpha", "hht", "bdf", "rattle"}) {
    const Motion motion(scene, tight("r-omega", method, 0.2, 1e-7));
    EXPECT_LE(apart(motion, exact), 5e-3) << method;
  }
}

TEST(LowOrder, ReversibleStepsKeepTheEnergyErrorBounded) {
  const scenes::Scene scene = catalogue_scene("double_pendulum");
  SimulationOptions options = tight("r-omega", "rattle", 20, 1e-5);
  const double early = Motion(scene, options).report.unaccounted_energy;
  options.end = 200;
  EXPECT_LE(Motion(scene, options).report.unaccounted_energy, 3 * early);
}

}  // namespace
}  // namespace trivium
