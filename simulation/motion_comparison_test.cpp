/// The comparison of one motion in several formulations: it holds for the library's formulations, and detects
/// a formulation with a relative error of 1e-9 in gamma.

#include "simulation/motion_comparison.hpp"

#include <gtest/gtest.h>

#include "formulations/equations_of_motion_impl.hpp"
#include "formulations/printed/augmented_solver_impl.hpp"
#include "formulations/printed/error_estimate_impl.hpp"
#include "formulations/side_by_side_impl.hpp"
#include "formulations/structured/acceleration_solver_impl.hpp"
#include "integrators/methods.hpp"
#include "scenes/generators.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/testing/catalogue_scene.hpp"
#include "simulation/simulate_impl.hpp"

namespace trivium {
namespace {

/// r-p with a relative error of 1e-9 in the bias of its body vectors, and so in gamma.
template <class S>
struct Off : RP<S> {
  static constexpr std::string_view name = "r-p-off";
  struct Kinematics : RP<S>::Kinematics {
    BodyVector<S> vector(const Vector3<S>& a_bar) const {
      BodyVector<S> v = RP<S>::Kinematics::vector(a_bar);
      v.bias *= 1 + S(1e-9);
      return v;
    }
  };
  static Kinematics kinematics(const NoChart& chart, const Vector3<S>& r, const Vector3<S>& r_dot,
                               const typename RP<S>::Coordinates& q) {
    return {RP<S>::kinematics(chart, r, r_dot, q)};
  }
  struct Reduced : RP<S>::Reduced {
    BodyVector<S> vector(const Vector3<S>& a_bar) const {
      BodyVector<S> v = RP<S>::Reduced::vector(a_bar);
      v.bias *= 1 + S(1e-9);
      return v;
    }
  };
};

using WithOff = AllFormulations::With<Off>;

ComparedFormulation off() {
  return {"r-p-off",
          [](const Model<double>& model, const SimulationOptions& options, SimulationObserver& observer) {
            SimulationOptions its_own = options;
            its_own.formulation = "r-p-off";
            return simulate_in<Off<double>>(model, its_own, observer);
          },
          [](const Model<double>& model, const RowAnalysis& rows, const ChartOptions& charts) {
            return side_by_side<WithOff>(model, rows, {{"r-p-off"}, charts}).formulations.front();
          }};
}

SimulationOptions run(const std::string& integrator, double end, std::optional<double> step = {}) {
  SimulationOptions options;
  options.integrator = integrator;
  options.end = end;
  options.step = step;
  return options;
}

Model<double> model_of(const std::string& name) { return make_model<double>(test::catalogue_scene(name)); }

MotionComparison compare_in(const std::string& scene, const SimulationOptions& asked,
                            std::vector<ComparedFormulation> more = {}) {
  ComparisonOptions options;
  options.run = asked;
  auto all = compared_formulations({}, *integrators::find_method(asked.integrator));
  all.insert(all.end(), more.begin(), more.end());
  return compare_motion(all, model_of(scene), options);
}

TEST(MotionComparison, HoldsForTheFormulationsOfTheLibrary) {
  for (const char* scene : {"spatial_slider_crank", "heavy_top", "stewart_platform", "driven_crank"}) {
    const MotionComparison c = compare_in(scene, run("dopri5", 1));
    EXPECT_TRUE(c.complete() && c.has_unique_lambda && c.holds_along() && c.holds_at_states()) << scene;
    EXPECT_EQ(c.instants.size(), 101u);
    EXPECT_EQ(c.runs.size(), formulation_names().size());
  }
}

TEST(MotionComparison, AnErrorOfAPartIn1e9InOneGammaExceedsTheBoundAtOneState) {
  const MotionComparison c = compare_in("spatial_slider_crank", run("dopri5", 1), {off()});
  ASSERT_TRUE(c.complete()) << c.runs.back().error;
  EXPECT_FALSE(c.holds_at_states());
}

TEST(MotionComparison, GivenStepsAreBoundByWhatHalfOfThemChanges) {
  const MotionComparison c = compare_in("spatial_slider_crank", run("generalized-alpha", 0.5, 1e-3));
  EXPECT_TRUE(c.complete() && c.holds_along() && c.holds_at_states());
  EXPECT_EQ(c.neighbour_distance, 0);
  EXPECT_GT(c.instants.back().lambda_bound, c.instants.back().lambda);
}

TEST(MotionComparison, WhereNeighbouringMotionsPartLambdaIsNotJudged) {
  const MotionComparison c = compare_in("triple_pendulum", run("dopri5", 10));
  ASSERT_TRUE(c.judged_until.has_value());
  EXPECT_LT(*c.judged_until, 10);
  EXPECT_FALSE(c.is_judged(c.instants.back()));
  EXPECT_TRUE(c.holds_along());
  EXPECT_GT(c.instants.back().amplification, 1e4);
}

TEST(MotionComparison, WhereTheBoundIsNoSmallDifferenceLambdaIsNotJudged) {
  SimulationOptions loose = run("dopri5", 10);
  loose.tolerances = {1e-4, 1e-10};
  for (const char* scene : {"spatial_slider_crank", "heavy_top", "double_pendulum"}) {
    const MotionComparison c = compare_in(scene, loose);
    ASSERT_TRUE(c.judged_until.has_value()) << scene;
    for (const ComparedInstant& now : c.instants) EXPECT_TRUE(!c.is_judged(now) || now.lambda_bound <= 0.1);
    EXPECT_TRUE(c.holds_along()) << scene;
  }
}

TEST(MotionComparison, APassageOfASingularPositionIsAmplifiedInOneOfTheNeighbours) {
  SimulationOptions options = run("dopri5", 5);
  options.tolerances = {1e-7, 1e-10};
  options.output_step = 0.1;  // an output at 4.6 s is near a singular position that no step sees
  const MotionComparison c = compare_in("n_four_bar_2", options);
  EXPECT_TRUE(c.complete() && c.holds_along());
}

TEST(MotionComparison, MechanismsBeyondTheDenseSolverAreComparedAlongTheMotionAlone) {
  const Model<double> chain = make_model<double>(scenes::chain(1000));
  ComparisonOptions options;
  options.run = run("dopri5", 0.02);
  options.outputs = 2;
  const auto formulations = compared_formulations({}, *integrators::find_method("dopri5"));
  const MotionComparison c = compare_motion(formulations, chain, options);
  EXPECT_TRUE(c.complete() && c.holds_along());
  EXPECT_GT(c.neighbour_distance, 0);
  for (const ComparedInstant& now : c.instants) EXPECT_FALSE(now.one_state.has_value());
}

TEST(MotionComparison, WhereTheConstraintsLeaveNoNeighbourNothingIsAmplified) {
  const MotionComparison c = compare_in("uwsbel_slider_crank", run("dopri5", 0.2));
  EXPECT_EQ(c.neighbour_distance, 0);
  EXPECT_EQ(c.instants.back().amplification, 1);
}

TEST(MotionComparison, WithoutUniqueMultipliersThereIsNothingToCompare) {
  const MotionComparison c = compare_in("four_bar", run("dopri5", 0.5));
  EXPECT_FALSE(c.has_unique_lambda);
  EXPECT_TRUE(c.holds_along() && c.holds_at_states());
}

TEST(MotionComparison, AccelerationsAreHeldToTheBoundWhereNoMultiplierIsUnique) {
  const MotionComparison c = compare_in("four_bar", run("dopri5", 0.5), {off()});
  ASSERT_TRUE(c.complete() && !c.has_unique_lambda);
  EXPECT_FALSE(c.holds_at_states());
}

TEST(MotionComparison, ARunThatFailsIsSaidAndNothingIsCompared) {
  ComparedFormulation failing = off();
  failing.simulate = [](const Model<double>&, const SimulationOptions&,
                        SimulationObserver&) -> SimulationReport { throw ModelError("it does not move"); };
  const MotionComparison c = compare_in("heavy_top", run("dopri5", 0.5), {failing});
  EXPECT_FALSE(c.complete() || c.holds_along() || c.holds_at_states());
  EXPECT_EQ(c.runs.back().error, "it does not move");
  EXPECT_TRUE(c.instants.empty());
}

}  // namespace
}  // namespace trivium
