/// The error estimates of `simulate --verify`, compared with the true errors.

#include "simulation/step_verification.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "validation/testing/catalogue_motion.hpp"

namespace trivium {
namespace {

using test::catalogue_scene, test::Motion, test::stepping, test::tight;

/// The largest error of positions [m] at any output.
double true_error(const Motion& motion, const Motion& exact) {
  double largest = 0;
  for (std::size_t k = 0; k < motion.samples.size(); ++k)
    for (std::size_t b = 0; b < motion.samples[k].state.pose.size(); ++b)
      raise(largest, (motion.samples[k].state.pose[b].r - exact.samples[k].state.pose[b].r).norm());
  return largest;
}

struct Case {
  const char* scene;
  double step, end;
};

class VerifiedSteps : public testing::TestWithParam<Case> {};

TEST_P(VerifiedSteps, FindAtLeastAThirdOfTheTrueErrorOrSayThatTheFigureIsNotReliable) {
  const scenes::Scene scene = catalogue_scene(GetParam().scene);
  SimulationOptions reference = tight("r-omega", "rkf78", GetParam().end, 1e-13);
  reference.output_step = GetParam().end / 4;
  const Motion exact(scene, reference);
  int reliable = 0;
  for (const integrators::MethodInfo& method : integrators::methods()) {
    if (!method.takes_given_steps) continue;
    SimulationOptions options =
        stepping("r-omega", std::string(method.name), GetParam().end, GetParam().step);
    options.output_step = reference.output_step;
    const Motion motion(scene, options);
    const std::vector<ErrorByHalving> errors = verify_steps(make_model<double>(scene), options);
    ASSERT_EQ(errors.size(), 5u);
    const ErrorByHalving& positions = errors[0];
    if (!positions.is_reliable()) continue;
    ++reliable;
    // the reference itself is exact to about 1e-11
    EXPECT_GE(positions.error, true_error(motion, exact) / 3 - 1e-11) << method.name;
    EXPECT_LE(positions.error, 3 * true_error(motion, exact) + 1e-10) << method.name;
  }
  EXPECT_GE(reliable, 8);
}

INSTANTIATE_TEST_SUITE_P(Scenes, VerifiedSteps,
                         testing::Values(Case{"spatial_slider_crank", 2e-3, 0.4},
                                         Case{"double_pendulum", 2e-3, 0.4}, Case{"heavy_top", 2e-5, 0.04}),
                         [](const auto& of) { return std::string(of.param.scene); });

// The memory of the saved run belongs to its step; the runs with half and a quarter of it begin without
// memory.
TEST(VerifiedSteps, OfARunThatGoesOnAreReliableToo) {
  const scenes::Scene scene = catalogue_scene("double_pendulum");
  SimulationOptions options = stepping("r-omega", "generalized-alpha", 0.2, 1e-3);
  const Motion first(scene, options);
  Model<double> rest = make_model<double>(scene);
  rest.state = first.report.end.state;
  options.from = first.report.end.run;
  options.end = 0.4;
  Samples samples;
  simulate(rest, options, samples);
  for (const ErrorByHalving& error : verify_steps(rest, options)) {
    if (error.quantity == "lambda")
      continue;  // after a restart the raw lambda of the first steps has one order less
    EXPECT_TRUE(error.is_reliable()) << error.quantity << " " << *error.order;
  }
}

// bdf of order 1 damps the pendulum: after 100 s both motions hang at rest, but on the way they differ
TEST(VerifiedSteps, OfAMotionThatEndsAtRestAreNotTakenForExact) {
  const scenes::Scene scene = catalogue_scene("simple_pendulum");
  SimulationOptions options = stepping("r-omega", "bdf", 100, 0.1);
  options.parameters.order = 1;
  const ErrorByHalving positions = verify_steps(make_model<double>(scene), options)[0];
  EXPECT_TRUE(!positions.is_reliable() || positions.error >= 0.1) << positions.error;
}

// At these steps the errors of a method of order 8 are rounding.
TEST(VerifiedSteps, OfRoundingAreNoReasonForAlarm) {
  SimulationOptions options = stepping("r-omega", "rkf78", 1, 1e-3);
  for (const ErrorByHalving& error : verify_steps(make_model<double>(catalogue_scene("heavy_top")), options))
    EXPECT_TRUE(error.is_reliable()) << error.quantity << " " << error.error;
}

TEST(VerifiedSteps, HaveNoFigureForMultipliersOfWhichNoneIsUnique) {
  const SimulationOptions options = stepping("r-omega", "dopri5", 0.1, 1e-2);
  const auto compared = [&](const char* name) {
    return verify_steps(make_model<double>(catalogue_scene(name)), options).back().quantity;
  };
  EXPECT_EQ(compared("four_bar"), "angular velocities");
  EXPECT_EQ(compared("simple_pendulum"), "lambda");
}

// the energy of a fast top does not show a wrong precession
TEST(VerifiedSteps, OfAFastTopShowAWrongPrecession) {
  const scenes::Scene scene = catalogue_scene("heavy_top");
  const Motion exact(scene, tight("r-omega", "rkf78", 0.3, 1e-13));
  SimulationOptions options = stepping("r-p", "hht", 0.3, 4e-3);
  const Motion motion(scene, options);
  const double error = (motion.end().state.pose[0].r - exact.end().state.pose[0].r).norm();
  EXPECT_GE(error, 0.01);
  const ErrorByHalving positions = verify_steps(make_model<double>(scene), options)[0];
  EXPECT_TRUE(!positions.is_reliable() || positions.error >= error / 3) << positions.error;
  EXPECT_GE(positions.error, error / 10);
}

}  // namespace
}  // namespace trivium
