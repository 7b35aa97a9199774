/// The work of drivers and dampers explains the change of energy; the angles of springs are counted over full
/// turns.

#include <cmath>

#include "scenes/testing/scene_builders.hpp"
#include "validation/testing/catalogue_motion.hpp"

namespace trivium {
namespace {

using test::implicit_methods, test::catalogue_scene, test::Implicit, test::InEveryFormulation, test::Motion,
    test::stepping, test::tight;

TEST_P(InEveryFormulation, WorkOfDriversAndDampersAccountsForTheEnergy) {
  for (const char* name : {"driven_crank", "basic_drivers", "open_arm_7", "flyball_governor"}) {
    const bool is_stiff = std::string(name) == "flyball_governor";
    const Motion motion(catalogue_scene(name), tight(GetParam(), "dopri5", is_stiff ? 0.05 : 1, 1e-10));
    EXPECT_TRUE(motion.report.does_work);
    EXPECT_GT(std::abs(motion.report.work), 1e-3) << name;
    EXPECT_LE(motion.report.unaccounted_energy, 1e-7 * (1 + std::abs(motion.report.energy_start))) << name;
  }
}

// The spring is wound up by three turns and back: theta = 6 pi sin(t).
TEST_P(InEveryFormulation, ATorsionalSpringIsCountedOverFullTurns) {
  scenes::Scene scene;
  scene.name = "wound_up";
  scene.bodies.push_back(test::body("rotor", 1, {1, 1, 1}));
  const double pi = std::acos(-1.0), rate = 6 * pi;
  scene.bodies[0].angular_velocity = {0, 0, rate};
  scene.constraints.push_back(test::joint(JointType::revolute, "hinge",
                                          test::side(scenes::ground, {}, {{0, 0, 1}}, {{1, 0, 0}}),
                                          test::side(0, {}, {{0, 0, 1}}, {{1, 0, 0}})));
  TorsionalSpringDamper<double> spring;
  spring.angle.joint = 0;
  spring.stiffness = 1;
  scene.effects.emplace_back(spring);
  SimulationOptions options = tight(GetParam(), "rkf78", 5, 1e-11);
  options.output_step = 0.25;
  const Motion motion(scene, options);
  for (const MotionSample& s : motion.samples)
    EXPECT_NEAR(s.state.twist[0].omega_bar[2], rate * std::cos(s.state.t), 1e-8) << s.state.t;
  EXPECT_LE(motion.report.unaccounted_energy, 1e-8 * motion.report.energy_start);
}

// A fast wheel on a weak spring turns almost uniformly: the error estimate alone would allow steps of many
// turns.
TEST_P(InEveryFormulation, NoStepLosesCountOfTheTurns) {
  const scenes::Scene scene = test::sprung_wheel(0.5, 20, 0.2, 0);
  for (const char* method : {"dopri5", "rkf78", "bulirsch-stoer", "abm", "cvode-adams", "arkode-erk"}) {
    const Motion motion(scene, tight(GetParam(), method, 5, 1e-6));
    EXPECT_NEAR(motion.end().state.twist[0].omega_bar[2], 20 * std::cos(5 * std::sqrt(0.4)), 1e-3) << method;
    // the errors of cvode-adams accumulate over many short steps
    EXPECT_LE(motion.report.unaccounted_energy, method == std::string("cvode-adams") ? 2e-2 : 1e-3) << method;
  }
}

// These methods also integrate the work of dampers and drivers.
TEST_P(Implicit, WorkAccountsForTheEnergy) {
  for (const char* name : {"driven_crank", "open_arm_7"})
    for (const std::string& method : implicit_methods) {
      const Motion motion(catalogue_scene(name), stepping(GetParam(), method, 0.5, 0.001));
      EXPECT_GT(std::abs(motion.report.work), 1e-3) << name;
      EXPECT_LE(motion.report.unaccounted_energy, 2e-2 * (1 + motion.report.largest_kinetic))
          << name << " " << method;
    }
}

}  // namespace
}  // namespace trivium
