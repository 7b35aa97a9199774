/// What a solution of the augmented system must satisfy, on random mechanisms.

#include "formulations/printed/augmented_solver.hpp"
#include "formulations/printed/sparsity.hpp"

#include <Eigen/QR>

#include "bodies/numbers/quad.hpp"
#include "bodies/numbers/scalar.hpp"
#include "bodies/rotations/so3.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "formulations/joint_reaction.hpp"
#include "formulations/testing/printed_solution.hpp"
#include "formulations/testing/random_mechanism.hpp"
#include "formulations/testing/solve_scene.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/testing/scene_builders.hpp"

namespace trivium {
namespace {

using test::distance, test::for_all, test::Solved;

test::MechanismOptions draw_options() {
  test::MechanismOptions options;
  options.bodies = *rc::gen::inRange(1, 5);
  options.closings = *rc::gen::inRange(0, 2);
  options.doubled = *rc::gen::inRange(0, 2);
  options.driven = *rc::gen::arbitrary<bool>() && options.doubled == 0;
  return options;
}
scenes::Scene draw_scene() {
  const auto options = draw_options();
  return test::random_scene(*rc::gen::inRange(0, 100000), options);
}

template <class F>
class Solutions : public testing::Test {};
TYPED_TEST_SUITE(Solutions, test::AllFormulations<double>, test::FormulationNames);

/// The size of lambda's effects: what rounding is to be measured against.
template <class F>
double force_scale(const Solved<F>& s) {
  double scale = 1;
  for (std::size_t k = 0; k < s.mechanism.rows.size(); ++k) {
    const auto& row = s.solver.equations().row[k];
    const double gradient = row.r_i.norm() + row.r_j.norm() + row.rot_i.norm() + row.rot_j.norm();
    scale = std::max(scale, std::abs(s.u.lambda[k]) * gradient);
  }
  return scale;
}

TYPED_TEST(Solutions, MatrixFreeResidualIsAtRoundingLevel) {
  using F = TypeParam;
  for_all(
      [] {
        Solved<F> s(draw_scene());
        const MatrixFreeResidual residual = s.solver.residual(s.solver.expand(s.solver.solve_reduced()));
        RC_ASSERT(residual.bodies <= 1e-13);
        RC_ASSERT(residual.rows <= 1e-13);
        // what was left out holds by itself, to what the consistency of the scene is worth
        RC_ASSERT(residual.dependent_rows <= 1e-11 * s.rows.kappa);
      },
      60);
}

TYPED_TEST(Solutions, MatrixFreeResidualSeesAWrongSolution) {
  using F = TypeParam;
  Solved<F> s(test::random_scene(5));
  for (const Eigen::Index k : {Eigen::Index(0), s.x.size() / 2, s.x.size() - 1}) {
    VectorX<double> wrong = s.x;
    wrong[k] += 1e-6 * (1 + std::abs(wrong[k]));
    const MatrixFreeResidual residual = s.solver.residual(wrong);
    EXPECT_GE(std::max(residual.bodies, residual.rows), 1e-10) << k;
  }
  VectorX<double> undefined = s.x;
  undefined[0] = std::nan("");
  const MatrixFreeResidual residual = s.solver.residual(undefined);
  EXPECT_TRUE(std::isnan(residual.bodies));
}

TYPED_TEST(Solutions, BalanceTheMomentumOfEveryBody) {
  using F = TypeParam;
  for_all(
      [] {
        const Solved<F> s(draw_scene());
        const auto& eom = s.solver.equations();
        const auto applied = applied_wrenches(s.mechanism, eom.body, eom.t);
        const PhysicalSolution<double> physical = s.solver.accelerations_of(s.x);
        for (int b = 0; b < s.mechanism.nb(); ++b) {
          Vector3<double> force = applied[b].F, torque = eom.body[b].A * applied[b].n_bar;
          for (const auto& joint : s.mechanism.joints)
            for (const End end : {End::i, End::j}) {
              if ((end == End::i ? joint.i : joint.j) != b) continue;
              const Reaction<double> reaction = joint_reaction<F>(eom, joint, s.u.lambda, end);
              force += reaction.force;
              torque += reaction.torque;
            }
          const auto& [mass, J] = s.mechanism.bodies[b];
          const Vector3<double>& w = s.state.twist[b].omega_bar;
          const double scale = force_scale(s);
          // Newton: m r'' = sum of forces. Euler: Jbar omega_bar' + omega_bar~ Jbar omega_bar = sum of
          // torques.
          RC_ASSERT(distance(mass * physical.r_ddot[b], force) <= 1e-12 * scale);
          RC_ASSERT(distance(J * physical.omega_bar_dot[b] + w.cross(J * w),
                             eom.body[b].A.transpose() * torque) <= 1e-11 * scale);
        }
      },
      60);
}

TYPED_TEST(Solutions, ReactionsOfEveryJointDoNoVirtualWork) {
  using F = TypeParam;
  for_all(
      [] {
        const Solved<F> s(draw_scene());
        const auto& eom = s.solver.equations();
        const TangentSystem tangent = tangent_system(s.mechanism, s.state);
        for (const auto& joint : s.mechanism.joints) {
          // any displacement of the two bodies that this joint's own rows allow
          VectorX<double> step =
              test::Random(joint.first_row + 1).vector<double, 24>().head(6 * s.mechanism.nb());
          const MatrixX<double> Phi = tangent.Phi.middleRows(joint.first_row, joint.rows);
          Eigen::CompleteOrthogonalDecomposition<MatrixX<double>> rows(Phi);
          for (int pass = 0; pass < 2; ++pass) step -= rows.solve(Phi * step);
          double work = 0;
          for (const End end : {End::i, End::j}) {
            const int b = end == End::i ? joint.i : joint.j;
            if (b == s.mechanism.ground()) continue;
            const Reaction<double> reaction = joint_reaction<F>(eom, joint, s.u.lambda, end);
            work += reaction.force.dot(step.segment<3>(6 * b)) +
                    reaction.torque.dot(eom.body[b].A * step.segment<3>(6 * b + 3));
          }
          RC_ASSERT(std::abs(work) <= 1e-12 * force_scale(s));
        }
      },
      60);
}

TYPED_TEST(Solutions, LambdaHasMinimumNormAmongTheEquivalent) {
  using F = TypeParam;
  for (int seed = 0; seed < 20; ++seed) {
    const Solved<F> s(test::random_scene(seed, {.bodies = 3, .closings = 1, .doubled = 1}));
    ASSERT_FALSE(s.rows.dependent.empty());
    const VectorX<double> E_lambda = s.rows.E.cwiseProduct(s.u.lambda);
    const MatrixX<double> EN = s.rows.E.asDiagonal() * s.rows.null_basis;
    EXPECT_LE((EN.transpose() * E_lambda).cwiseAbs().maxCoeff(), 1e-12 * E_lambda.norm());
    // the same forces as with the redundant multipliers at zero
    const Unknowns<F> plain = s.solver.split(s.solver.expand(s.solver.solve_reduced()));
    const TangentSystem tangent = tangent_system(s.mechanism, s.state);
    for (int k : s.rows.dependent) EXPECT_EQ(plain.lambda[k], 0);
    EXPECT_LE(distance(tangent.Phi.transpose() * plain.lambda, tangent.Phi.transpose() * s.u.lambda),
              1e-11 * force_scale(s));
    for (std::size_t k = 0; k < s.rows.unique.size(); ++k)
      if (s.rows.unique[k]) {
        EXPECT_EQ(plain.lambda[k], s.u.lambda[k]);
      }
    EXPECT_LE(E_lambda.norm(), s.rows.E.cwiseProduct(plain.lambda).norm() * (1 + 1e-12));
  }
}

// ---- all formulations together

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
    ASSERT_EQ(result.formulations.size(), 4u);
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

/// A rotor on a bearing along its axis of symmetry, which points nowhere in particular.
scenes::Scene rotor(double spin) {
  scenes::Scene scene;
  scene.bodies = {test::body("rotor", 1.2, {0.003, 0.003, 0.005})};
  scene.bodies[0].orientation = scenes::EulerParameters{{0.8, 0.3, 0.4, 0.33}};
  scene.bodies[0].angular_velocity = {0, 0, spin};
  const Vector3<double> z = rotation_matrix<double>(Vector4<double>(0.8, 0.3, 0.4, 0.33).normalized()).col(2);
  scene.constraints = {
      test::joint(ConstraintType::revolute, "bearing",
                  test::side(scenes::ground, scenes::Vector3{}, scenes::Vector3{z[0], z[1], z[2]}),
                  test::side(0, scenes::Vector3{}, scenes::Vector3{0, 0, 1}))};
  return scene;
}

TEST(BalancedRotor, HasADiscrepancyWithinWhatCancels) {
  for (const double spin : {30.0, 3000.0}) {
    const auto result = test::solve_scene<double>(rotor(spin));
    EXPECT_LE(result.discrepancy().lambda, result.lambda_bound() * result.cancellation()) << spin;
    // nothing acts and nothing is felt: what lambda there is, is rounding, and no reason to worry
    for (const auto& f : result.formulations) EXPECT_LE(f.estimate.lambda, 1e-6) << f.name;
  }
}

/// Two bodies in space on a rope, and a spring and damper between them.
scenes::Scene roped_pair() {
  auto scene = test::random_scene(3, {.bodies = 3, .closings = 0});
  auto rope = test::joint(ConstraintType::d, "rope", test::side(0), test::side(1));
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
    auto rope = test::joint(ConstraintType::d, "rope", test::side(scenes::ground, anchor), test::side(0));
    rope.f = 6.0;
    scene.constraints = {rope};
    scenes::SpringDamper spring;
    spring.i = test::side(0, scenes::Vector3{0.1, 0.2, -0.1});
    spring.j = test::side(scenes::ground, scenes::Vector3{x + 3, 2 * x, -x / 4});
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
  scene.constraints = {test::joint(ConstraintType::spherical, "ball",
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

/// Size and nonzeros of the printed matrix of a scene, all rows in it.
template <class F>
std::pair<long, long> printed_matrix(const scenes::Scene& scene) {
  const Solved<F> s(scene);
  const MatrixX<double> K = augmented_system(s.solver.equations()).matrix();
  return {K.rows(), (K.array() != 0.0).count()};
}

TEST(Sparsity, IsThatOfThePrintedMatrix) {
  for (int seed = 0; seed < 10; ++seed) {
    const auto scene = test::random_scene(seed, {.bodies = 3, .doubled = seed % 2});
    const auto nc = make_mechanism<double>(scene).nc();
    const auto found = augmented_sparsity(make_model<double>(scene));
    ASSERT_EQ(found.size(), 3u);
    const std::array expected{printed_matrix<ROmega<double>>(scene), printed_matrix<RP<double>>(scene),
                              printed_matrix<REpsilon<double>>(scene)};
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(found[k].size, (found[k].name == "r-p" ? 8 : 6) * 3 + nc);
      EXPECT_EQ(found[k].size, expected[k].first) << found[k].name;
      EXPECT_EQ(found[k].nonzeros, expected[k].second) << found[k].name;
    }
  }
}

}  // namespace
}  // namespace trivium
