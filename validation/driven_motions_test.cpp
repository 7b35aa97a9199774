/// Drivers and loads that fade, rise suddenly or lose their grip.

#include <cmath>

#include "validation/hard/driven_scenes.hpp"
#include "validation/testing/catalogue_motion.hpp"

namespace trivium {
namespace {

using test::catalogue_scene, test::InEveryFormulation, test::Motion, test::stepping, test::tight;

/// A motion that must end near `time` [s] with an error that names this driver.
void expect_end_by(const std::string& driver, const scenes::Scene& scene, const SimulationOptions& options,
                   double time, double within) {
  try {
    const Motion motion(scene, options);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("driver \"" + driver + '"'), std::string::npos) << error.what();
    EXPECT_NEAR(error.when().value_or(0), time, within);
  }
}

// Positions of a rounding become accelerations of 1e-6 rad/s^2, beside which the forces vanish.
TEST_P(InEveryFormulation, AWheelWithoutALoadTurnsSteadilyAtAnyStep) {
  for (const char* method : {"bdf", "generalized-alpha", "generalized-alpha-gl2", "hht"})
    for (const double h : {1e-2, 1e-3, 1e-4, 1e-5}) {
      const Motion motion(hard::near_parallel(0.5), stepping(GetParam(), method, h < 1e-4 ? 0.2 : 1, h));
      EXPECT_LE((motion.end().state.twist[0].omega_bar - Vector3<double>(0, 0, 1)).norm(), 1e-7 + 0.1 * h * h)
          << method << " " << h;
    }
}

// The error estimate of the method itself is 0 there.
TEST_P(InEveryFormulation, Rkf78SeesAPulseWithinAStep) {
  const Motion exact(hard::unmarked_pulses(0.1), stepping(GetParam(), "rkf78", 1, 1e-3));
  const auto error = [&](double rtol) {
    const Motion motion(hard::unmarked_pulses(0.1), tight(GetParam(), "rkf78", 1, rtol));
    return (motion.end().state.twist[0].r_dot - exact.end().state.twist[0].r_dot).norm();
  };
  for (const double rtol : {1e-4, 1e-6, 1e-8}) EXPECT_LE(error(rtol), 30 * rtol) << rtol;
}

// cos^64 falls to 1e-132 within a second, by up to 1e12 a step
// The times of the stages are rounded to a part of the step.
TEST_P(InEveryFormulation, Rkf78TakesStepsOfAFewRoundingsOfTheTime) {
  constexpr double late = 1e9, longest = 1e-5;
  Samples samples;
  simulate(make_model<double>(hard::unmarked_pulses(0.1), late),
           tight(GetParam(), "rkf78", late + longest, 1e-8), samples);
  constexpr double strongest = 10;  // [m/s^2]
  EXPECT_LE(samples.all.back().state.twist[0].r_dot.norm(), 1.1 * strongest * longest);
}

TEST_P(InEveryFormulation, ALoadMayFadeToNothing) {
  for (const char* method : {"bdf", "generalized-alpha", "generalized-alpha-gl2", "hht"})
    EXPECT_EQ(Motion(hard::unmarked_pulses(0.1), stepping(GetParam(), method, 1, 1e-3)).end().state.t, 1)
        << method;
}

// The impulse is that of the function, whatever its width.
TEST_P(InEveryFormulation, RattleWithTolerancesFollowsASuddenPulse) {
  if (!goes_with(*integrators::find_method("rattle"), GetParam())) GTEST_SKIP();
  for (const double width : {0.1, 1e-3, 1e-5}) {
    const Motion motion(hard::smooth_pulse(width), tight(GetParam(), "rattle", 1, 1e-8));
    EXPECT_NEAR(motion.end().state.twist[0].r_dot[0], 1, 2e-5) << width;
  }
}

// The motion is a polynomial of order 2, which ida follows with any step; the power is none.
TEST_P(InEveryFormulation, WorkIsAccurateWhereIdaFindsTheMotionEasy) {
  const Motion sliding(hard::closing_distance(0.5), tight(GetParam(), "ida", 2, 1e-8));
  EXPECT_LE(sliding.report.unaccounted_energy, 5e-4);
  const Motion linked(catalogue_scene("uwsbel_four_link"), tight(GetParam(), "ida", 3, 1e-8));
  EXPECT_LE(linked.report.unaccounted_energy, 3e-3 * linked.report.largest_kinetic);
}

// A slide that comes to rest at the ground can go on to either side; one that stops before it turns back.
TEST_P(InEveryFormulation, ADriverAtRestWithoutGripIsNamed) {
  SimulationOptions options = tight(GetParam(), "radau9", 2, 1e-8);
  options.output_step = 0.5;
  EXPECT_EQ(Motion(hard::closing_distance(1e-6), options).end().state.t, 2);
  expect_end_by("drive", hard::closing_distance(0), options, 1, 1e-3);
}

// The cosine of 1e-7 rad changes by 1e-7 per rad.
TEST_P(InEveryFormulation, ADriverThatStartsWithoutGripIsNamed) {
  for (const char* method : {"radau9", "bdf", "ida"}) {
    try {
      const auto options = std::string(method) == "ida" ? tight(GetParam(), method, 1, 1e-8)
                                                        : stepping(GetParam(), method, 1, 1e-3);
      const Motion motion(hard::near_parallel(1e-7), options);
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("driver \"drive\""), std::string::npos) << error.what();
    }
  }
}

// The step that ends there meets the constraints, its interpolated output does not.
TEST(ADriverOutOfReach, IsNamedAtAnOutputWithinAStep) {
  SimulationOptions options = tight("r-omega", "rattle", 1, 1e-8);
  options.output_step = 0.05;
  expect_end_by("pull", hard::infeasible(0.5), options, 0.5, 1e-6);
}

// A start close to the end of the reach has little grip itself.
TEST_P(InEveryFormulation, ADriverThatStartsCloseToTheEndOfItsReachIsNamed) {
  for (const char* method :
       {"dopri5", "generalized-alpha", "arkode-dirk"})  // the last ends three steps before
    expect_end_by("pull", hard::infeasible(0.01), stepping(GetParam(), method, 1, 1e-4), 0.01, 4e-4);
}

// Both roots of the driven distance satisfy a step from 1e-7 m to 1.1e-6 m; rattle takes the wrong one.
TEST_P(InEveryFormulation, AStepToTheWrongSideOfADeadPointIsNamed) {
  for (const char* method : {"rattle", "rattle4"}) {
    if (!goes_with(*integrators::find_method(method), GetParam())) continue;
    for (const double least : {1e-7, 3e-8, 1e-8}) {
      try {
        const Motion motion(hard::closing_distance(least), stepping(GetParam(), method, 2, 1e-3));
        EXPECT_NEAR(motion.end().state.pose[0].r[0], 1, 1e-6) << method << " " << least;
      } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("driver \"drive\""), std::string::npos) << error.what();
        EXPECT_NEAR(error.when().value_or(0), 1, 5e-3);
      }
    }
  }
}

}  // namespace
}  // namespace trivium
