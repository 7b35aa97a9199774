/// Rank, unique multipliers, null space and kappa of mechanisms for which they are known.

#include "formulations/analysis/row_analysis.hpp"

#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "formulations/analysis/tangent_system.hpp"
#include "formulations/side_by_side.hpp"
#include "formulations/testing/random_mechanism.hpp"
#include "formulations/testing/solve_scene.hpp"
#include "mechanism/mechanism_cast.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/testing/scene_builders.hpp"
#include "scenes/testing/two_link_arm.hpp"

namespace trivium {
namespace {

using test::distance, test::for_all;

/// A door: a body on coaxial revolutes about the global z axis at the given heights [m, times length].
scenes::Scene door(const std::vector<double>& heights, double length = 1) {
  scenes::Scene scene;
  scene.bodies = {test::body("door", 10, {3 * length * length, 2 * length * length, 2 * length * length},
                             {0.5 * length, 0.1 * length, 0.3 * length})};
  for (const double z : heights)
    scene.constraints.push_back(
        test::joint(JointType::revolute, "hinge " + std::to_string(scene.constraints.size()),
                    test::side(scenes::ground, scenes::Vector3{0, 0, z * length}, scenes::Vector3{0, 0, 1}),
                    test::side(0, scenes::Vector3{-0.5 * length, -0.1 * length, (z - 0.3) * length},
                               scenes::Vector3{0, 0, 1})));
  scene.effects = {test::gravity()};
  return scene;
}

/// A planar four-bar linkage in the xy plane with four revolutes.
scenes::Scene four_bar(double length = 1) {
  const std::array<scenes::Vector3, 4> corner{
      {{0, 0, 0}, {0.2 * length, 0.5 * length, 0}, {1.3 * length, 0.9 * length, 0}, {1.0 * length, 0, 0}}};
  scenes::Scene scene;
  for (int b = 0; b < 3; ++b) {
    scenes::Vector3 centre;
    for (int k = 0; k < 3; ++k) centre[k] = (corner[b][k] + corner[b + 1][k]) / 2;
    const double J = 0.1 * length * length;
    scene.bodies.push_back(test::body("bar " + std::to_string(b), 1 + b, {J, J, J}, centre));
  }
  for (int k = 0; k < 4; ++k) {
    const int i = k - 1, j = k == 3 ? scenes::ground : k;
    const auto side = [&](int body) {
      scenes::Vector3 s = corner[k];
      if (body != scenes::ground)
        for (int m = 0; m < 3; ++m) s[m] -= scene.bodies[body].position[m];
      return scenes::Side{body, s, {}, scenes::Vector3{0, 0, 1}, {}};
    };
    scene.constraints.push_back(test::joint(JointType::revolute, std::string(1, static_cast<char>('A' + k)),
                                            side(k == 0 ? scenes::ground : i), side(j)));
  }
  scene.effects = {test::gravity()};
  return scene;
}

TangentSystem tangent(const scenes::Scene& scene) {
  return tangent_system(make_mechanism<double>(scene), make_state<double>(scene));
}

/// Expects Phi^T N = 0, orthonormal E N, and zero rows of N where lambda is unique.
void expect_null_basis(const TangentSystem& s, const RowAnalysis& rows) {
  const MatrixX<double>& N = rows.null_basis;
  const double size = rows.E.maxCoeff() * N.cwiseAbs().maxCoeff();
  EXPECT_LE((s.Phi.transpose() * N).cwiseAbs().maxCoeff(),
            1e-12 * s.Phi.cwiseAbs().maxCoeff() * N.cwiseAbs().maxCoeff());
  const MatrixX<double> EN = rows.E.asDiagonal() * N;
  EXPECT_LE(distance(EN.transpose() * EN, MatrixX<double>::Identity(N.cols(), N.cols())), 1e-12) << size;
  for (Eigen::Index k = 0; k < N.rows(); ++k) EXPECT_EQ(rows.unique[k], N.row(k).isZero(0));
}

std::vector<std::string> names(const scenes::Scene& scene, const std::vector<int>& rows) {
  const auto mechanism = make_mechanism<double>(scene);
  std::vector<std::string> out;
  for (int k : rows) out.push_back(mechanism.row_names[k]);
  return out;
}

TEST(RowAnalysis, OfADoorOnTwoHingesHasRankFiveOfTen) {
  const auto scene = door({0, 2});
  const RowAnalysis rows = analyse_rows(make_model<double>(scene));
  EXPECT_EQ(rows.rank, 5);
  EXPECT_EQ(rows.independent, (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(names(scene, rows.dependent),
            (std::vector<std::string>{"hinge 1.cd(e_x)", "hinge 1.cd(e_y)", "hinge 1.cd(e_z)",
                                      "hinge 1.dp1(u_i, z_j)", "hinge 1.dp1(v_i, z_j)"}));
  EXPECT_EQ(rows.unique, std::vector<bool>(10, false));
  EXPECT_EQ(rows.null_basis.cols(), 5);
  expect_null_basis(tangent(scene), rows);
}

TEST(RowAnalysis, OfASpatialFourBarHasRankSeventeenOfTwenty) {
  const auto scene = four_bar();
  const RowAnalysis rows = analyse_rows(make_model<double>(scene));
  EXPECT_EQ(rows.rank, 17);
  EXPECT_EQ(rows.dependent.size(), 3u);
  // only the forces in the plane are unique: cd(e_x) and cd(e_y) of every joint
  std::vector<bool> in_plane;
  for (int joint = 0; joint < 4; ++joint)
    for (const bool unique : {true, true, false, false, false}) in_plane.push_back(unique);
  EXPECT_EQ(rows.unique, in_plane);
  for (int k : rows.dependent) EXPECT_FALSE(rows.unique[k]);
  expect_null_basis(tangent(scene), rows);
}

TEST(RowAnalysis, OfIndependentRowsFindsAllUnique) {
  for_all(
      [] {
        test::MechanismOptions options;
        options.bodies = *rc::gen::inRange(1, 5);
        options.closings = 0;
        const auto scene = test::random_scene(*rc::gen::inRange(0, 1000), options);
        const RowAnalysis rows = analyse_rows(make_model<double>(scene));
        const std::size_t nc = rows.unique.size();
        RC_ASSERT(rows.rank == static_cast<int>(nc));
        RC_ASSERT(rows.dependent.empty());
        RC_ASSERT(rows.unique == std::vector<bool>(nc, true));
        RC_ASSERT(rows.null_basis.cols() == 0);
        RC_ASSERT(rows.kappa >= 1.0);
      },
      50);
}

TEST(RowAnalysis, OfDoubledJointsFindsWhatIsRedundant) {
  for_all(
      [] {
        test::MechanismOptions options;
        options.bodies = *rc::gen::inRange(1, 4);
        const int seed = *rc::gen::inRange(0, 1000);
        options.doubled = 0;
        const auto single = analyse_rows(make_model<double>(test::random_scene(seed, options)));
        options.doubled = 1;
        const auto scene = test::random_scene(seed, options);
        const RowAnalysis rows = analyse_rows(make_model<double>(scene));
        RC_ASSERT(rows.rank == single.rank);
        RC_ASSERT(rows.rank + static_cast<int>(rows.dependent.size()) ==
                  static_cast<int>(rows.unique.size()));
        // the doubled joints are last in the file, and the last rows are chosen as dependent
        for (int k = 0; k < rows.rank; ++k) RC_ASSERT(rows.independent[k] == single.independent[k]);
        expect_null_basis(tangent(scene), rows);
      },
      50);
}

TEST(RowAnalysis, DoesNotDependOnTheUnitOfLength) {
  for (const double unit : {1e-3, 1.0, 1e3}) {
    const RowAnalysis hinges = analyse_rows(make_model<double>(door({0, 2, 5}, unit))),
                      metres = analyse_rows(make_model<double>(door({0, 2, 5})));
    EXPECT_EQ(hinges.rank, 5);
    EXPECT_EQ(hinges.unique, metres.unique);
    EXPECT_EQ(hinges.dependent, metres.dependent);
    EXPECT_NEAR(hinges.kappa, metres.kappa, 1e-9 * metres.kappa);
    const RowAnalysis bars = analyse_rows(make_model<double>(four_bar(unit))),
                      bars_1 = analyse_rows(make_model<double>(four_bar()));
    EXPECT_EQ(bars.rank, 17);
    EXPECT_EQ(bars.unique, bars_1.unique);
    EXPECT_EQ(bars.dependent, bars_1.dependent);
    EXPECT_NEAR(bars.kappa, bars_1.kappa, 1e-9 * bars_1.kappa);
  }
}

TEST(RowAnalysis, OfOneAssemblyDoesNotDependOnAnotherBesideIt) {
  // two points 10 micrometres apart, and a door of 10 km that is not connected to them
  auto scene = door({0, 2}, 1e4);
  scenes::Body small = test::body("small", 1);
  small.position = {3, 0, 0};
  scene.bodies.push_back(small);
  const double s = 1e-5;
  scene.constraints.push_back(test::joint(
      JointType::spherical, "ball", test::side(scenes::ground, scenes::Vector3{3, 0, 0}), test::side(1)));
  scene.constraints.push_back(
      test::joint(JointType::in_line, "slot",
                  test::side(scenes::ground, scenes::Vector3{3, 0, 0}, scenes::Vector3{0, 0, 1}),
                  test::side(1, scenes::Vector3{0, 0, s})));
  EXPECT_EQ(analyse_rows(make_model<double>(scene)).rank, 5 + 5);
}

TEST(RowAnalysis, KappaAndETimesLambdaDoNotDependOnTheScaleOfARow) {
  TangentSystem s = tangent(test::random_scene(7, {.bodies = 3, .closings = 2}));
  const RowAnalysis before = analyse_rows(s);
  const Eigen::Index nc = s.Phi.rows();
  VectorX<double> scale(nc);
  for (Eigen::Index k = 0; k < nc; ++k) scale[k] = std::pow(10.0, test::Random(k + 1).uniform(-3, 3));
  s.Phi = (scale.asDiagonal() * s.Phi).eval();
  s.gamma = scale.cwiseProduct(s.gamma);
  const RowAnalysis after = analyse_rows(s);
  EXPECT_EQ(after.rank, before.rank);
  EXPECT_NEAR(after.kappa, before.kappa, 1e-9 * before.kappa);
  // a row multiplied by c has lambda / c, so E lambda does not change
  EXPECT_LE(distance(after.E.cwiseQuotient(scale), before.E), 1e-12 * before.E.maxCoeff());
  EXPECT_LE(distance(after.schur_rhs_bound.cwiseQuotient(scale), before.schur_rhs_bound),
            1e-12 * before.schur_rhs_bound.maxCoeff());
  EXPECT_NEAR(after.acceleration_bound, before.acceleration_bound, 1e-12 * before.acceleration_bound);
}

TEST(RowAnalysis, KappaAndEAreThoseOfTheirDefinition) {
  // one rope on a body: S = Phi M^-1 Phi^T is a number, E its root; two ropes at right angles: kappa = 1
  scenes::Scene scene;
  scene.bodies = {test::body("weight", 4)};
  const auto rope = [&](const char* name, const scenes::Vector3& end) {
    auto c = test::joint(JointType::distance, name, test::side(scenes::ground, end), test::side(0));
    c.distance = 2;
    return c;
  };
  scene.constraints = {rope("up", {0, 0, 2})};
  const RowAnalysis one = analyse_rows(make_model<double>(scene));
  EXPECT_NEAR(one.E[0], 2 * 2 / std::sqrt(4.0), 1e-15);  // |2 d| / sqrt(m)
  EXPECT_EQ(one.kappa, 1);
  scene.constraints.push_back(rope("aside", {2, 0, 0}));
  EXPECT_NEAR(analyse_rows(make_model<double>(scene)).kappa, 1, 1e-15);
  // 60 degrees apart: the equilibrated S is [1, 1/2; 1/2, 1]
  scene.constraints[1] = rope("slanted", {2 * std::sqrt(0.75), 0, 1});
  EXPECT_NEAR(analyse_rows(make_model<double>(scene)).kappa, 3, 1e-14);
}

/// A body on three spherical joints in one line, the last one off it by `off` [m].
scenes::Scene three_pins(double off) {
  scenes::Scene scene;
  scene.bodies = {test::body("b", 1, {0.1, 0.2, 0.15}, {1, 0, 0})};
  for (int k = 0; k < 3; ++k) {
    const double y = k == 2 ? off : 0.0, z = k;
    scene.constraints.push_back(test::joint(JointType::spherical, "s" + std::to_string(k),
                                            test::side(scenes::ground, scenes::Vector3{0, y, z}),
                                            test::side(0, scenes::Vector3{-1, y, z})));
  }
  return scene;
}

TEST(RowAnalysis, SaysWhichRowTheToleranceKeepsOrLeavesOutByANarrowMargin) {
  struct Case {
    double off;
    int rank;
    bool is_narrow;
  };
  for (const Case& c : {Case{0, 5, false}, Case{1e-12, 5, false}, Case{3e-9, 5, true}, Case{3e-8, 5, true},
                        Case{3e-7, 6, true}, Case{1e-4, 6, false}}) {
    const RowAnalysis rows = analyse_rows(make_model<double>(three_pins(c.off)));
    EXPECT_EQ(rows.rank, c.rank) << c.off;
    ASSERT_EQ(rows.narrow.size(), c.is_narrow ? 1u : 0u) << c.off;
    ASSERT_EQ(rows.warnings.size(), rows.narrow.size());
    if (!c.is_narrow) continue;
    EXPECT_EQ(rows.narrow[0].counts(), c.rank == 6);
    // the share of the gradient is about the misalignment over the size of the body
    EXPECT_GT(rows.narrow[0].share, 0.02 * c.off);
    EXPECT_LT(rows.narrow[0].share, c.off);
    EXPECT_NE(rows.warnings[0].find(c.rank == 6 ? "counts as independent" : "is left out"), std::string::npos)
        << rows.warnings[0];
  }
}

TEST(RowAnalysis, DecidesByTheRankToleranceOfTheScene) {
  struct Case {
    double off, tolerance;
    int rank;
  };
  for (const Case& c : {Case{3e-8, 1e-8, 5}, Case{3e-8, 1e-9, 6}, Case{1e-11, 1e-13, 6}, Case{1e-5, 1e-8, 6},
                        Case{1e-5, 1e-4, 5}}) {
    scenes::Scene scene = three_pins(c.off);
    scene.rank_tolerance = c.tolerance;
    const Model<double> model = make_model<double>(scene);
    EXPECT_EQ(analyse_rows(model).rank, c.rank) << c.off;
    EXPECT_EQ(analyse_rows(Model<double>{mechanism_cast<double>(model.mechanism), model.state}).rank, c.rank);
  }
}

Model<double> two_links(double bend) { return make_model<double>(test::two_link_arm(bend)); }

// two links in a line reach no farther; bent by a little they reach a little less
TEST(FreeMotion, OfADriverFallsToZeroAtTheEndOfItsReach) {
  const auto gradient = [](double bend) {
    const Model<double> model = two_links(bend);
    return free_motion(tangent_system(model.mechanism, model.state), model.mechanism.nc() - 1).gradient;
  };
  EXPECT_GT(gradient(1), 0.1);
  EXPECT_NEAR(gradient(1e-3) / gradient(1e-4), 10, 0.1);
  EXPECT_LE(gradient(0), 1e-15);
}

TEST(FreeMotion, AndItsCurvatureTellHowFarARowCanReach) {
  for (const double bend : {0.3, 0.1, 0.01}) {
    Model<double> model = two_links(bend);
    const int row = model.mechanism.nc() - 1;
    const TangentSystem s = tangent_system(model.mechanism, model.state);
    const FreeMotion motion = free_motion(s, row);
    EXPECT_NEAR(s.Phi.row(row).dot(motion.q_dot), motion.gradient, 1e-14);
    EXPECT_LE((s.Phi.topRows(row) * motion.q_dot).norm(), 1e-14);
    for (std::size_t b = 0; b < 2; ++b)
      model.state.twist[b] = {motion.q_dot.segment<3>(6 * b), motion.q_dot.segment<3>(6 * b + 3)};
    const VectorX<double> gamma = tangent_system(model.mechanism, model.state).gamma;
    const double curvature = free_curvature(s, row, gamma);
    EXPECT_LT(curvature, 0);
    const double missing = 2 - 2 * std::cos(bend);  // 2^2 - |d|^2
    EXPECT_NEAR(-motion.gradient * motion.gradient / (2 * curvature), missing, missing * bend);
  }
}

TEST(RowAnalysis, OfNothingIsEmpty) {
  scenes::Scene scene;
  scene.bodies = {test::body("free", 1)};
  const RowAnalysis rows = analyse_rows(make_model<double>(scene));
  EXPECT_EQ(rows.rank, 0);
  EXPECT_TRUE(rows.unique.empty() && rows.independent.empty() && rows.dependent.empty());
  EXPECT_EQ(rows.kappa, 1);
}

// rows without a gradient: d . d between points that coincide

scenes::Constraint points_together(const char* name) {
  return test::joint(basic_type<D>, name, test::side(scenes::ground), test::side(0, scenes::Vector3{}));
}

TEST(RowAnalysis, OfARowWithoutGradientHasRankZero) {
  scenes::Scene scene;
  scene.bodies = {test::body("weight", 1)};
  scene.constraints = {points_together("nothing")};
  const RowAnalysis rows = analyse_rows(make_model<double>(scene));
  EXPECT_EQ(rows.rank, 0);
  EXPECT_EQ(rows.kappa, 1);
  EXPECT_EQ(rows.dependent, std::vector<int>{0});
  EXPECT_EQ(rows.unique, std::vector<bool>{false});
}

TEST(RowAnalysis, ARowWithoutGradientDoesNotDisturbTheOthers) {
  scenes::Scene scene;
  scene.bodies = {test::body("weight", 2)};
  const auto ball = [](const char* name) {
    return test::joint(JointType::spherical, name, test::side(scenes::ground, scenes::Vector3{0, 0, 1}),
                       test::side(0, scenes::Vector3{0, 0, 1}));
  };
  scene.constraints = {ball("first"), points_together("nothing"), ball("second")};
  scene.effects = {test::gravity(10)};
  const RowAnalysis rows = analyse_rows(make_model<double>(scene));
  EXPECT_EQ(rows.rank, 3);
  EXPECT_EQ(rows.dependent, (std::vector<int>{3, 4, 5, 6}));
  EXPECT_EQ(rows.unique, std::vector<bool>(7, false));
  // two balls share the weight of 20 N equally: lambda = -10 each, and 0 in the row without a gradient
  VectorX<double> expected(7);
  expected << 0, 0, -10, 0, 0, 0, -10;
  for (const auto& formulation : test::solve_scene<double>(scene).formulations) {
    ASSERT_EQ(formulation.error, "");
    EXPECT_LE(distance(formulation.solution.lambda, expected), 1e-13) << formulation.name;
  }
}

}  // namespace
}  // namespace trivium
