/// Simulations through positions where rows lose rank or a chart is singular. Such positions are passed, and
/// drift does not create false ones.

#include <cmath>

#include "scenes/testing/scene_builders.hpp"
#include "simulation/system/trouble_of_rows.hpp"
#include "validation/hard/known_motions.hpp"
#include "validation/harness/trusted_numbers.hpp"
#include "validation/testing/catalogue_motion.hpp"

namespace trivium {
namespace {

using test::catalogue_scene, test::InEveryFormulation, test::Motion, test::tight;

TEST_P(InEveryFormulation, FortyFourBarsPassTheirSingularPositions) {
  const TrustedNumbers exact(TRIVIUM_REFERENCE_DIR, "n_four_bar_40");
  SimulationOptions options = tight(GetParam(), "dopri5", 10, 1e-9);
  options.output_step = 5;
  const Motion motion(catalogue_scene("n_four_bar_40"), options);
  // the table gives the position of B0; the centre of the last coupler is at B0 + (39.5, 0)
  for (const auto& [sample, row] : {std::pair(1, 50), {2, 100}}) {
    ASSERT_EQ(exact["t"][row], motion.samples[sample].state.t);
    const auto& r = motion.samples[sample].state.pose.back().r;
    EXPECT_LE(std::hypot(r[0] - 39.5 - exact["x"][row], r[1] - exact["y"][row]), 1e-6);
  }
  EXPECT_FALSE(motion.report.passages.empty());
}

// The loop needs one of two redundant rows. Each of these rows vanishes somewhere, but such a place is not
// singular.
TEST_P(InEveryFormulation, ChoicesOfRowsThatVanishAreNoSingularPositions) {
  const Motion motion(catalogue_scene("parallelogram"), tight(GetParam(), "rkf78", 2));
  EXPECT_TRUE(motion.report.passages.empty());
  EXPECT_LE(motion.report.unaccounted_energy, 1e-9);
  EXPECT_LE(motion.report.phi, 1e-11);  // after every step, also near the flat position
}

// The driver cos(theta) = f(t) reaches f = -1; the crank must continue in all formulations, at all
// tolerances.
TEST_P(InEveryFormulation, ACosineDriverPassesItsDeadPoint) {
  for (const double rtol : {1e-6, 1e-8, 1e-10}) {
    const Motion motion(catalogue_scene("uwsbel_four_link"), tight(GetParam(), "dopri5", 1, rtol));
    EXPECT_NEAR(motion.end().state.pose[2].r[0], -2.43744228108569, 1e-9) << rtol;
    EXPECT_LE(motion.end().phi, 1e-13);
  }
}

// Rounding errors of a distant or fast body must not affect the analysis of the other bodies.
TEST_P(InEveryFormulation, AnotherBodySpoilsNoSingularPosition) {
  const TrustedNumbers exact(TRIVIUM_REFERENCE_DIR, "n_four_bar_1");
  scenes::Scene scene = catalogue_scene("n_four_bar_1");
  scene.bodies.push_back(test::body("stone", 1e-3, {1, 1, 1}, {1000, 0, 0}));
  scene.bodies.back().velocity = {300, 0, 0};
  scene.bodies.back().angular_velocity = {1, 0, 0};
  const Motion motion(scene, tight(GetParam(), "dopri5", 10, 1e-10));
  const auto& r = motion.end().state.pose[2].r;
  EXPECT_LE(std::hypot(r[0] - 0.5 - exact["x"].back(), r[1] - exact["y"].back()), 1e-6);
}

// The rows of a spherical joint are never dependent, though their condition number depends on the position;
// and the top has inertia in all directions, though not at a stage that is far off.
TEST(ALongStep, IsNamedAsTheReason) {
  for (const auto& [formulation, step] : {std::pair("r-epsilon", 5e-3), {"r-p", 0.05}}) try {
      const Motion motion(catalogue_scene("heavy_top"), test::stepping(formulation, "rkf78", 2, step));
      FAIL() << "reached " << motion.report.reached;
    } catch (const Error& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.find("singular position"), std::string::npos) << what;
      EXPECT_NE(what.find("take smaller steps"), std::string::npos) << what;
    }
}

// The body is then far from the origin, and its spring is long; neither is the reason.
TEST_P(InEveryFormulation, AnUnstableStepIsNamedAsTheReason) {
  for (const double damping : {0, 100, 900})
    for (const char* method : {"dopri5", "abm", "hem4"}) try {
        const Motion motion(hard::orbit_on_spring(2e7, damping),
                            test::stepping(GetParam(), method, 10, 2e-3));
        FAIL() << method << " reached " << motion.report.reached;
      } catch (const Error& error) {
        const std::string what = error.what();
        EXPECT_EQ(what.find("origin"), std::string::npos) << what;
        EXPECT_NE(what.find("body \"stone\" accelerates most"), std::string::npos) << what;
        EXPECT_NE(what.find("take smaller steps"), std::string::npos) << what;
      }
}

TEST(ASingularPosition, IsTheReasonOfAFailureJustBeforeAndBehindIt) {
  const scenes::Scene scene = hard::rod_on_crank(3);
  const auto mechanism = make_mechanism<double>(scene);
  const auto start = make_state<double>(scene);
  const auto trouble_at = [&](double t) {
    MechanismState<double> state = start;
    state.t = t;
    hard::set_rod_on_crank(state, 3);
    return trouble_of_rows(mechanism, {}, start, state);
  };
  const double at_right_angle = 0.6196;  // of the crank [s]
  for (const double away : {-0.01, -0.001, 0.001, 0.01})
    EXPECT_NE(trouble_at(at_right_angle + away).find("near a singular position"), std::string::npos) << away;
  for (const double away : {-0.1, 0.1}) EXPECT_EQ(trouble_at(at_right_angle + away), "");
}

TEST_P(InEveryFormulation, AMethodThatEndsAtASingularPositionNamesARowAndSaysWhatToTry) {
  try {
    const Motion motion(catalogue_scene("n_four_bar_1"), tight(GetParam(), "hedop5", 5, 1e-8));
    FAIL() << "reached " << motion.report.reached;
  } catch (const Error& error) {
    const std::string what = error.what();
    // a revolute of the loop
    EXPECT_TRUE(what.find("row \"A") != what.npos || what.find("row \"B") != what.npos) << what;
    EXPECT_NE(what.find("another of dopri5"), what.npos) << what;
  }
}

// The steps of ida become too small some way before it.
TEST_P(InEveryFormulation, ASingularPositionAheadIsTheReasonOfStepsThatBecomeTooSmall) {
  try {
    const Motion motion(hard::rod_on_crank(3), tight(GetParam(), "ida", 5, 1e-12));
    FAIL() << "reached " << motion.report.reached;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("near a singular position, where row \"B"), std::string::npos)
        << error.what();
  }
}

// the motion starts upright; nearly so, it is the mass matrix that is singular, though the body has inertia
TEST(TheRawChart, IsAnErrorThatNamesTheBodyWhereItIsSingular) {
  SimulationOptions options = tight("r-epsilon", "dopri5", 5, 1e-9);
  options.charts = {*parse_euler_sequence("313"), false};
  for (const double angle : {0.0, 1e-10}) try {
      scenes::Scene scene = catalogue_scene("heavy_top");
      if (angle > 0) {
        scene.bodies[0].orientation = scenes::AxisAngle{scenes::Vector3{1, 0, 0}, angle};
        scene.constraints.clear();
      }
      const Motion motion(scene, options);
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

// With drift, redundant rows look independent; the number of redundant rows must not change.
TEST_P(InEveryFormulation, DriftMakesNoRedundantRowIndependent) {
  // the parallelogram ends shortly before its flat position
  for (const auto& [name, end] : {std::pair("parallelogram", 1.525), {"bricard", 5}, {"four_bar", 5}}) {
    SimulationOptions options = tight(GetParam(), "dopri5", end, 1e-6);
    options.projects = false;
    const Motion motion(catalogue_scene(name), options);
    EXPECT_LE(motion.report.unaccounted_energy, 0.01) << name;
    EXPECT_TRUE(motion.report.passages.empty());
  }
}

}  // namespace
}  // namespace trivium
