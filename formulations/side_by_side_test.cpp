/// All formulations at one state give the same lambda, for any precision, charts and common motion of the
/// bodies

#include "formulations/side_by_side.hpp"

#include "bodies/numbers/quad.hpp"
#include "bodies/numbers/scalar.hpp"
#include "bodies/rotations/so3.hpp"
#include "bodies/testing/properties.hpp"
#include "formulations/printed/sparsity.hpp"
#include "formulations/testing/printed_solution.hpp"
#include "formulations/testing/random_mechanism.hpp"
#include "formulations/testing/solve_scene.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/testing/scene_builders.hpp"

namespace trivium {
namespace {

TEST(NonUniqueLambda, IsAsPreciseAsTheScalar) {
  for (int seed = 0; seed < 5; ++seed) {
    const auto scene = test::random_scene(seed, {.bodies = 2, .closings = 1, .doubled = 1});
    SolveOptions options;
    const auto result = test::solve_scene<Quad>(scene, options, false);
    ASSERT_FALSE(result.rows.dependent.empty());
    const auto& reference = result.formulations[0].solution.lambda;
    const auto in_double = test::solve_scene<double>(scene, options, false);
    for (std::size_t f = 0; f < result.formulations.size(); ++f) {
      const double size = static_cast<double>(reference.norm());
      EXPECT_LE(static_cast<double>((result.formulations[f].solution.lambda - reference).norm()),
                1e-28 * size)
          << result.formulations[f].name;
      EXPECT_LE((in_double.formulations[f].solution.lambda - scalar_cast<double>(reference)).norm(),
                1e-11 * size);
    }
  }
}

template <class S>
void expect_lambda_is_invariant(int scenes, const ChartOptions& charts = {}) {
  const double u = static_cast<double>(unit_roundoff<S>());
  for (int seed = 0; seed < scenes; ++seed) {
    const auto scene = test::random_scene(
        seed,
        {.bodies = 1 + seed % 4, .closings = seed % 3, .doubled = seed % 5 == 0, .driven = seed % 5 == 1});
    SolveOptions options;
    options.charts = charts;
    const auto result = test::solve_scene<S>(scene, options, false);
    ASSERT_EQ(result.formulations.size(), formulation_names().size());
    for (const auto& formulation : result.formulations) EXPECT_EQ(formulation.error, "") << seed;
    const Discrepancy worst = result.discrepancy();
    const double bound = lambda_bound(u, result.rows.kappa);
    EXPECT_LE(worst.lambda, bound) << "scene " << seed << ", kappa " << result.rows.kappa;
    EXPECT_LE(worst.r_ddot, bound) << "scene " << seed;
    EXPECT_LE(worst.omega_bar_dot, bound) << "scene " << seed;
  }
}

TEST(Invariance, LambdaIsTheSameInAllFormulationsInDouble) { expect_lambda_is_invariant<double>(100); }
TEST(Invariance, LambdaIsTheSameInAllFormulationsInFloat) { expect_lambda_is_invariant<float>(40); }
TEST(Invariance, LambdaIsTheSameInAllFormulationsInLongDouble) {
  expect_lambda_is_invariant<long double>(40);
}
TEST(Invariance, LambdaIsTheSameInAllFormulationsInQuad) { expect_lambda_is_invariant<Quad>(12); }
TEST(Invariance, LambdaIsTheSameInEverySequence) {
  for (const auto name : euler_sequence_names)
    expect_lambda_is_invariant<double>(8, {*parse_euler_sequence(name), true});
}

/// A rotor on a bearing along its axis of symmetry, in a general direction.
scenes::Scene rotor(double spin) {
  scenes::Scene scene;
  scene.bodies = {test::body("rotor", 1.2, {0.003, 0.003, 0.005})};
  scene.bodies[0].orientation = scenes::EulerParameters{{0.8, 0.3, 0.4, 0.33}};
  scene.bodies[0].angular_velocity = {0, 0, spin};
  const Vector3<double> z = rotation_matrix<double>(Vector4<double>(0.8, 0.3, 0.4, 0.33).normalized()).col(2);
  scene.constraints = {
      test::joint(JointType::revolute, "bearing",
                  test::side(scenes::ground, scenes::Vector3{}, scenes::Vector3{z[0], z[1], z[2]}),
                  test::side(0, scenes::Vector3{}, scenes::Vector3{0, 0, 1}))};
  return scene;
}

TEST(BalancedRotor, HasADiscrepancyWithinWhatCancels) {
  for (const double spin : {30.0, 3000.0}) {
    const auto result = test::solve_scene<double>(rotor(spin));
    EXPECT_LE(result.discrepancy().lambda, result.lambda_bound() * result.cancellation()) << spin;
    // without loads lambda consists of rounding errors, and its error estimate must be small nevertheless
    for (const auto& f : result.formulations) EXPECT_LE(f.estimate.lambda, 1e-6) << f.name;
  }
}

// gamma of every row is rounding of terms that cancel; the second bearing makes rows dependent
TEST(BalancedRotor, OnTwoBearingsHasNoRowsThatContradictEachOther) {
  for (const double spin : {100.0, 3000.0, 1e5}) {
    scenes::Scene scene = rotor(spin);
    scene.constraints.push_back(scene.constraints[0]);
    auto& second = scene.constraints[1];
    second.name = "second";
    const auto& z = *second.i.axis;
    second.i.point = scenes::Vector3{0.7 * z[0], 0.7 * z[1], 0.7 * z[2]};
    second.j.point = scenes::Vector3{0, 0, 0.7};
    const Model<double> model = make_model<double>(scene);
    EXPECT_TRUE(analyse_rows(model).contradictory.empty()) << spin;
  }
}

TEST(BalancedRotor, IsNotTouchedByASpringWithoutLength) {
  scenes::Scene scene = rotor(100);
  const double before = test::solve_scene<double>(scene).cancellation();
  SpringDamper<double> spring;
  spring.i.body = scenes::ground;
  spring.stiffness = 10;
  spring.free_length = 0;
  scene.effects.push_back(spring);
  EXPECT_EQ(test::solve_scene<double>(scene).cancellation(), before);
}

/// A scene of three bodies without joints: a rope between two of them, and random effects with a spring.
scenes::Scene roped_pair() {
  auto scene = test::random_scene(3, {.bodies = 3, .closings = 0});
  auto rope = test::joint(basic_type<D>, "rope", test::side(0), test::side(1));
  double d2 = 0;
  for (int k = 0; k < 3; ++k) d2 += std::pow(scene.bodies[1].position[k] - scene.bodies[0].position[k], 2);
  rope.f = d2;
  scene.constraints = {rope};
  return scene;
}

TEST(Cancellation, DoesNotDependOnACommonVelocity) {
  auto scene = roped_pair();
  const double at_rest = test::solve_scene<double>(scene).cancellation();
  for (auto& body : scene.bodies) body.velocity[0] += 1024;
  EXPECT_NEAR(test::solve_scene<double>(scene).cancellation(), at_rest, 1e-9 * at_rest);
}

TEST(Invariance, LambdaIsTheSameHoweverFastAllBodiesFlyTogether) {
  for (const double v : {1e3, 1e5, 1e7}) {
    auto scene = roped_pair();
    for (auto& body : scene.bodies) body.velocity[0] += v;
    const auto result = test::solve_scene<double>(scene);
    EXPECT_LE(result.discrepancy().lambda, result.lambda_bound()) << v;
  }
}

TEST(Invariance, LambdaIsTheSameHoweverFarAwayAllBodiesAre) {
  for (const double x : {1e3, 1e5, 1e7}) {
    auto scene = roped_pair();
    for (auto& body : scene.bodies) body.position[0] += x;
    const auto result = test::solve_scene<double>(scene);
    EXPECT_LE(result.discrepancy().lambda, result.lambda_bound()) << x;
  }
}

TEST(Invariance, LambdaIsTheSameHoweverFarTheGroundHoldsItsBodies) {
  for (const double x : {1e3, 1e5, 1e7}) {
    scenes::Scene scene;
    scene.bodies = {test::body("buoy", 2, {0.3, 0.4, 0.5})};
    scene.bodies[0].position = {x + 1, 2 * x, -x / 4};
    scene.bodies[0].orientation = scenes::EulerParameters{{0.8, 0.3, 0.4, 0.33}};
    const scenes::Vector3 anchor{x, 2 * x + 2, -x / 4 + 1};
    auto rope = test::joint(basic_type<D>, "rope", test::side(scenes::ground, anchor), test::side(0));
    rope.f = 6.0;
    scene.constraints = {rope};
    SpringDamper<double> spring;
    spring.i = {0, {0.1, 0.2, -0.1}};
    spring.j = {scenes::ground, {x + 3, 2 * x, -x / 4}};
    spring.stiffness = 30;
    scene.effects = {test::gravity(), spring};
    const auto result = test::solve_scene<double>(scene);
    EXPECT_LE(result.discrepancy().lambda, result.lambda_bound()) << x;
    for (const auto& f : result.formulations) EXPECT_LE(f.estimate.lambda, 1e-14) << f.name << x;
  }
}

TEST(Cancellation, IsNoneWhereOneForceActs) {
  scenes::Scene scene;
  scene.bodies = {test::body("weight", 2)};
  scene.constraints = {test::joint(JointType::spherical, "ball",
                                   test::side(scenes::ground, scenes::Vector3{0, 0, 1}),
                                   test::side(0, scenes::Vector3{0, 0, 1}))};
  scene.effects = {test::gravity()};
  EXPECT_EQ(test::solve_scene<double>(scene).cancellation(), 1);
}

TEST(SideBySide, SingularRawChartIsAnErrorOfThatFormulationAlone) {
  scenes::Scene scene;
  scene.bodies = {test::body("top", 1)};
  scene.effects = {test::gravity()};
  SolveOptions options;
  options.charts.reframe = false;
  const auto result = test::solve_scene<double>(scene, options);
  for (const auto& formulation : result.formulations) {
    const bool has_chart = formulation.name.starts_with("r-epsilon");
    EXPECT_EQ(formulation.error.empty(), !has_chart) << formulation.name;
    if (has_chart) {
      EXPECT_NE(formulation.error.find("body \"top\""), std::string::npos) << formulation.error;
    }
  }
  EXPECT_EQ(result.discrepancy().r_ddot, 0);
}

TEST(SideBySide, ReportsChartsWhereThereAreAny) {
  scenes::Scene scene;
  scene.bodies = {test::body("upright", 1)};
  for (const auto& formulation : test::solve_scene<double>(scene).formulations) {
    if (formulation.name.starts_with("r-epsilon"))
      EXPECT_EQ(formulation.charts, std::vector<std::string>{"313 Rx(90)"});
    else
      EXPECT_TRUE(formulation.charts.empty());
  }
}

/// Size and number of nonzeros of the printed matrix of a scene, with all rows.
template <class F>
std::pair<long, long> printed_matrix(const scenes::Scene& scene) {
  const test::Solved<F> s(scene);
  const MatrixX<double> K = augmented_system(s.solver.equations()).matrix();
  return {K.rows(), (K.array() != 0.0).count()};
}

TEST(Sparsity, IsThatOfThePrintedMatrix) {
  for (int seed = 0; seed < 10; ++seed) {
    const auto scene = test::random_scene(seed, {.bodies = 3, .doubled = seed % 2});
    const auto nc = make_mechanism<double>(scene).nc();
    const auto found = augmented_sparsity(make_model<double>(scene));
    ASSERT_EQ(found.size(), formulation_names().size());
    for (const Sparsity& one : found) {
      const auto [size, nonzeros] =
          with_formulation<double>(one.name, [&]<class F>() { return printed_matrix<F>(scene); });
      EXPECT_EQ(one.size, (one.name == "r-p" ? 8 : 6) * 3 + nc);
      EXPECT_EQ(one.size, size) << one.name;
      EXPECT_EQ(one.nonzeros, nonzeros) << one.name;
    }
  }
}

}  // namespace
}  // namespace trivium
