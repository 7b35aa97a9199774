/// The comparison of formulations by the structured solver has the same results as the dense one.

#include "formulations/structured_side_by_side.hpp"

#include "formulations/testing/printed_and_structured.hpp"
#include "scenes/building.hpp"

namespace trivium {
namespace {

void expect_the_same(const Model<double>& model) {
  const SideBySide<double> dense = side_by_side(model, analyse_rows(model));
  const SideBySide<double> sparse = structured_side_by_side(model);
  const double allowed = std::max(1e-11, dense.lambda_bound());
  EXPECT_EQ(sparse.rows.rank, dense.rows.rank);
  EXPECT_EQ(sparse.rows.unique, dense.rows.unique);
  EXPECT_TRUE(std::isnan(sparse.rows.kappa));
  if (sparse.rows.E.size() == 0) {  // an inertia is singular
    EXPECT_TRUE(sparse.rows.unique.empty() || std::isnan(sparse.discrepancy().lambda));
    return;
  }
  EXPECT_LE((sparse.rows.E - dense.rows.E).norm(), 1e-12 * dense.rows.E.norm());
  EXPECT_LE((sparse.rows.acceleration_scale - dense.rows.acceleration_scale).norm(),
            1e-12 * dense.rows.acceleration_scale.norm());
  // the dense bound may be larger, since it adds magnitudes and so includes terms that cancel
  for (Eigen::Index k = 0; k < sparse.rows.E.size(); ++k)
    EXPECT_LE(sparse.rows.schur_rhs_bound[k], dense.rows.schur_rhs_bound[k] * (1 + 1e-10) + 1e-12);
  for (std::size_t f = 0; f < dense.formulations.size(); ++f) {
    const FormulationResult<double>&d = dense.formulations[f], &s = sparse.formulations[f];
    ASSERT_EQ(s.name, d.name);
    ASSERT_EQ(s.error.empty(), d.error.empty()) << s.error << d.error;
    if (!d.error.empty()) continue;
    EXPECT_EQ(s.charts, d.charts);
    EXPECT_LE(lambda_distance(dense.rows, s.solution.lambda, d.solution.lambda),
              allowed * dense.cancellation());
    EXPECT_LE(acceleration_distance(dense.rows, s.solution, d.solution).all, allowed);
    EXPECT_LE(s.residual.worst(), 1e-10);
    ASSERT_EQ(s.lambda_internal.size(), d.lambda_internal.size());
    EXPECT_LE((s.lambda_internal - d.lambda_internal).norm(), 1e-8 * (1 + d.lambda_internal.norm()));
    double largest_force = 1;
    for (const Reaction<double>& reaction : d.reactions) raise(largest_force, reaction.force.norm());
    for (std::size_t k = 0; k < s.reactions.size(); ++k) {
      const Reaction<double>&structured = s.reactions[k], &printed = d.reactions[k];
      EXPECT_LE((structured.point - printed.point).norm(), 1e-12 * (1 + printed.point.norm()));
      // a joint with a multiplier that is not unique has no unique reaction
      const Joint<double>& joint = model.mechanism.joints[k];
      const auto first = dense.rows.unique.begin() + joint.first_row;
      if (std::find(first, first + joint.rows, false) != first + joint.rows) continue;
      EXPECT_LE((structured.force - printed.force).norm(), 1e-9 * largest_force);
    }
  }
}

TEST(StructuredSideBySide, SaysWhatTheDenseOneDoesOfRandomMechanisms) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    expect_the_same(make_model<double>(test::varied_scene(seed)));
  }
}

TEST(StructuredSideBySide, SolvesInTheFormulationsThatAreNamed) {
  const Model<double> model = make_model<double>(test::varied_scene(1));
  const SideBySide<double> one = structured_side_by_side(model, {{"r-p"}, {}});
  ASSERT_EQ(one.formulations.size(), 1u);
  EXPECT_EQ(one.formulations.front().name, "r-p");
}

/// A top on a spherical joint at `tip`, whose middle Euler angle is `distance` from the singularity.
scenes::Scene top_near_singularity(double distance, const scenes::Vector3& tip) {
  scenes::Scene scene;
  scenes::Body top = building::body("top", 2, {0.4, 0.5, 0.3});
  top.orientation = scenes::EulerAngles{{0.4, distance, 0.3}, {}};
  top.angular_velocity = {1, 2, 3};
  scene.bodies = {top};
  scene.constraints = {building::joint(JointType::spherical, "pin",
                                       building::side(scenes::ground, scenes::Vector3{}),
                                       building::side(0, tip))};
  scene.effects = {building::gravity()};
  return scene;
}

TEST(StructuredSideBySide, StatesATenthOfItsErrorNearTheSingularityOfAChart) {
  constexpr double no_error = 1e-12;
  for (double distance = 0.2; distance > 2e-7; distance *= 0.83) {
    const SideBySide<double> all =
        structured_side_by_side(make_model<double>(top_near_singularity(distance, {0.1, 0.2, 0.3})),
                                {{"r-omega", "r-epsilon"}, {EulerSequence{}, false}});
    const FormulationResult<double>&exact = all.formulations[0], &lossy = all.formulations[1];
    if (!lossy.error.empty()) continue;
    const double error =
        (lossy.solution.lambda - exact.solution.lambda).norm() / exact.solution.lambda.norm();
    EXPECT_TRUE(error < no_error || lossy.estimate.lambda >= std::min(error, 1.0) / 10)
        << distance << ": " << error << " " << lossy.estimate.lambda;
  }
}

TEST(StructuredSideBySide, NamesTheChartIfRomegaHasASolution) {
  const scenes::Scene scene = top_near_singularity(1e-8, {});
  const ChartOptions kept{{}, false};
  for (const auto& found : structured_side_by_side(make_model<double>(scene), {{}, kept}).formulations) {
    if (found.name != "r-epsilon") {
      EXPECT_EQ(found.error, "") << found.name;
      continue;
    }
    EXPECT_EQ(
        found.error.find("body \"top\" at t = 0: the coordinates of r-epsilon are at a distance of 1.0e-08"),
        0u)
        << found.error;
  }
}

}  // namespace
}  // namespace trivium
