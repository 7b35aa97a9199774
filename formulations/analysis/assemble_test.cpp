/// Laws of consistency and assembly, and of generated scenes, which must be consistent without assembly.

#include "formulations/analysis/assemble.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>

#include "bodies/numbers/scalar.hpp"
#include "bodies/rotations/so3.hpp"
#include "formulations/side_by_side.hpp"
#include "formulations/testing/solve_scene.hpp"
#include "scenes/generators.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/scene_state.hpp"
#include "scenes/testing/catalogue_scene.hpp"

namespace trivium {
namespace {

using test::catalogue_scene;

Consistency consistency(const scenes::Scene& scene) {
  return check_consistency(make_mechanism<double>(scene), make_state<double>(scene));
}

scenes::Scene assembled(scenes::Scene scene) {
  set_state(scene, assemble(make_mechanism<double>(scene), make_state<double>(scene)));
  return scene;
}

scenes::Scene disturbed(const std::string& name, double by) {
  scenes::Scene scene = catalogue_scene(name);
  double sign = 1;
  for (scenes::Body& body : scene.bodies)
    for (int k = 0; k < 3; ++k, sign = -sign) {
      body.position[k] += sign * by;
      body.velocity[k] -= sign * by;
      body.angular_velocity[k] += sign * by;
    }
  return scene;
}

class Assembly : public testing::TestWithParam<const char*> {};

TEST_P(Assembly, BringsADisturbedStateBackToRounding) {
  const scenes::Scene scene = disturbed(GetParam(), 0.02);
  EXPECT_FALSE(consistency(scene).holds());
  const Consistency result = consistency(assembled(scene));
  EXPECT_TRUE(result.holds()) << result.report();
  EXPECT_LT(worst_size(result.positions), 1e-14);
  EXPECT_LT(worst_size(result.velocities), 1e-13);
}

TEST_P(Assembly, ChangesAConsistentStateByRoundingOnly) {
  const scenes::Scene before = catalogue_scene(GetParam()), after = assembled(before);
  for (std::size_t b = 0; b < before.bodies.size(); ++b)
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(after.bodies[b].position[k], before.bodies[b].position[k], 1e-14);
      EXPECT_NEAR(after.bodies[b].velocity[k], before.bodies[b].velocity[k], 1e-13);
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Assembly,
                         testing::Values("double_pendulum", "four_bar", "spatial_slider_crank",
                                         "parallelogram", "stewart_platform", "n_four_bar_2", "open_arm_7"),
                         [](const auto& test) { return std::string(test.param); });

/// The tangential share [-] of the displacement between two states: its component along the motions that the
/// constraints at `to` allow, relative to its norm, in the mass metric.
double share_along_constraints(const scenes::Scene& from, const scenes::Scene& to) {
  const auto mechanism = make_mechanism<double>(to);
  const auto start = make_state<double>(from), end = make_state<double>(to);
  const Eigen::Index n = 6 * mechanism.nb();
  VectorX<double> way(n), root(n);
  for (int b = 0; b < mechanism.nb(); ++b) {
    const Matrix3<double> turn =
        rotation_matrix(start.pose[b].p).transpose() * rotation_matrix(end.pose[b].p);
    way.segment<3>(6 * b) = end.pose[b].r - start.pose[b].r;
    way.segment<3>(6 * b + 3) =
        Vector3<double>(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1)) / 2;
    root.segment<3>(6 * b).setConstant(std::sqrt(mechanism.bodies[b].mass));
    // in the closed loops of the catalogue the principal axes are the body axes, or nearly so
    root.segment<3>(6 * b + 3) = mechanism.bodies[b].inertia.diagonal().cwiseSqrt();
  }
  const MatrixX<double> W =
      (tangent_system(mechanism, end).Phi * root.cwiseInverse().asDiagonal()).transpose();
  Eigen::CompleteOrthogonalDecomposition<MatrixX<double>> rows;
  rows.setThreshold(standard_rank_tolerance);
  rows.compute(W);
  const VectorX<double> weighted = root.cwiseProduct(way);
  const VectorX<double> across = W * rows.solve(weighted);
  return (weighted - across).norm() / weighted.norm();
}

class RedundantAssembly : public testing::TestWithParam<const char*> {};

TEST_P(RedundantAssembly, EndsAtTheNearestStateInTheMassMetric) {
  for (const double by : {1e-5, 1e-3}) {
    const scenes::Scene before = disturbed(GetParam(), by);
    EXPECT_LE(share_along_constraints(before, assembled(before)), 1e-3 + 10 * by) << by;
  }
}
INSTANTIATE_TEST_SUITE_P(Catalogue, RedundantAssembly,
                         testing::Values("four_bar", "parallelogram", "bricard", "door"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST(VelocityProjection, IsTheLeastChangeInTheMassMetric) {
  // the removed velocity is M-orthogonal to every velocity that the constraints allow
  scenes::Scene scene = catalogue_scene("open_arm_7");
  const auto mechanism = make_mechanism<double>(scene);
  const auto consistent = make_state<double>(scene);
  auto moved = consistent;
  for (std::size_t b = 0; b < moved.twist.size(); ++b) {
    moved.twist[b].r_dot += Vector3<double>(0.3, -0.2, 0.1);
    moved.twist[b].omega_bar += Vector3<double>(-0.1, 0.4, 0.2);
  }
  auto projected = moved;
  project_velocities(mechanism, projected);
  double product = 0, size = 0;
  for (std::size_t b = 0; b < moved.twist.size(); ++b) {
    const auto& body = mechanism.bodies[b];
    const Vector3<double> r_off = moved.twist[b].r_dot - projected.twist[b].r_dot;
    const Vector3<double> omega_off = moved.twist[b].omega_bar - projected.twist[b].omega_bar;
    const Vector3<double> r_in =
        projected.twist[b].r_dot - consistent.twist[b].r_dot;  // allowed, because this scene has no driver
    const Vector3<double> omega_in = projected.twist[b].omega_bar - consistent.twist[b].omega_bar;
    const double term = body.mass * r_off.dot(r_in) + omega_off.dot(body.inertia * omega_in);
    product += term;
    size += std::abs(term);
  }
  EXPECT_GT(size, 1e-6);
  EXPECT_LT(std::abs(product), 1e-12 * size);
}

TEST(Assembly, SaysWhichRowsCannotBeMet) {
  scenes::Scene scene = catalogue_scene("simple_pendulum");
  scenes::Constraint rod;
  rod.type = JointType::distance;
  rod.name = "too_long";
  rod.j.body = 0;
  rod.distance = 100;
  scene.constraints.push_back(rod);
  try {
    assembled(scene);
    FAIL() << "assembled what cannot be";
  } catch (const ModelError& error) {
    EXPECT_NE(std::string(error.what()).find("too_long"), std::string::npos) << error.what();
  }
}

TEST(Consistency, NamesTheOffendingRowsWithTheirResiduals) {
  scenes::Scene scene = catalogue_scene("spatial_slider_crank");
  scene.bodies[2].position[1] += 1e-3;
  const Consistency result = consistency(scene);
  EXPECT_FALSE(result.holds());
  EXPECT_NE(result.report().find("D.dp2(u_i) position: residual"), std::string::npos) << result.report();
}

TEST(Consistency, AnAntiparallelAxisIsAWrongBranch) {
  scenes::Scene scene = catalogue_scene("door");
  for (double& x : *scene.constraints[0].j.axis) x = -x;
  const Consistency result = consistency(scene);
  EXPECT_FALSE(result.holds());
  ASSERT_EQ(result.wrong_branches.size(), 1u);
  EXPECT_NE(result.wrong_branches[0].find(scene.constraints[0].name), std::string::npos);
}

/// A body on a joint with the ground, with a joint frame for which the rows hold on a wrong branch.
struct Turned {
  const char* name;
  ConstraintType type;
  scenes::Vector3 axis_j, x_j;

  friend void PrintTo(const Turned& turned, std::ostream* out) { *out << turned.name; }
};

class WrongBranch : public testing::TestWithParam<Turned> {};

TEST_P(WrongBranch, IsNamedThoughItsRowsHold) {
  scenes::Scene scene;
  scenes::Body body;
  body.name = "body";
  body.mass = 1;
  body.inertia = scenes::Vector3{1, 1, 1};
  scene.bodies = {body};
  scenes::Constraint joint;
  joint.type = GetParam().type;
  joint.name = "joint";
  joint.i = {scenes::ground, {}, {}, scenes::Vector3{0, 0, 1}, scenes::Vector3{1, 0, 0}};
  joint.j = {0, {}, {}, GetParam().axis_j, GetParam().x_j};
  scene.constraints = {joint};
  const Consistency result = consistency(scene);
  EXPECT_LT(worst_size(result.positions), 1e-15);
  ASSERT_FALSE(result.wrong_branches.empty());
  EXPECT_NE(result.wrong_branches[0].find("joint"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Joints, WrongBranch,
    testing::Values(Turned{"antiparallel_revolute", JointType::revolute, {0, 0, -1}, {1, 0, 0}},
                    Turned{"antiparallel_cylindrical", JointType::cylindrical, {0, 0, -1}, {1, 0, 0}},
                    Turned{"antiparallel_translational", JointType::translational, {0, 0, -1}, {1, 0, 0}},
                    Turned{"antiparallel_fixed", JointType::fixed, {0, 0, -1}, {1, 0, 0}},
                    Turned{"antiparallel_planar", JointType::planar, {0, 0, -1}, {1, 0, 0}},
                    Turned{"half_turned_translational", JointType::translational, {0, 0, 1}, {-1, 0, 0}},
                    Turned{"half_turned_fixed", JointType::fixed, {0, 0, 1}, {-1, 0, 0}}),
    testing::PrintToStringParamName());

TEST(Consistency, ADriverAHalfTurnOffIsAWrongBranch) {
  scenes::Scene scene = catalogue_scene("driven_crank");
  for (scenes::Constraint& c : scene.constraints)
    if (c.type == JointType::rotation_driver)
      c.angle = TimeFunction::Sum{{c.angle, TimeFunction(std::acos(-1.0))}};
  const Consistency result = consistency(scene);
  ASSERT_EQ(result.wrong_branches.size(), 1u) << result.report();
}

class Generated : public testing::TestWithParam<scenes::Scene> {};

TEST_P(Generated, IsConsistentAndHasOneLambda) {
  const Consistency result = consistency(GetParam());
  EXPECT_LT(worst_size(result.positions), 1e-13);
  EXPECT_LT(worst_size(result.velocities), 1e-13);
  SolveOptions options;
  const auto solution = test::solve_scene<double>(GetParam(), options, false);
  EXPECT_LE(solution.discrepancy().lambda, solution.lambda_bound());
}

INSTANTIATE_TEST_SUITE_P(Scenes, Generated,
                         testing::Values(scenes::chain(1), scenes::chain(20), scenes::ladder(3),
                                         scenes::tree(20), scenes::ring(3), scenes::ring(12), scenes::hub(9)),
                         [](const auto& test) { return test.param.name; });

TEST(GeneratedLadder, IsTheCataloguesNFourBar) {
  const scenes::Scene ours = scenes::ladder(2), theirs = catalogue_scene("n_four_bar_2");
  const auto generated = test::solve_scene<double>(ours), published = test::solve_scene<double>(theirs);
  EXPECT_EQ(generated.rows.rank, published.rows.rank);
  ASSERT_EQ(ours.bodies.size(), theirs.bodies.size());
  for (std::size_t a = 0; a < ours.bodies.size(); ++a) {
    const auto same_name = [&](const scenes::Body& body) { return body.name == ours.bodies[a].name; };
    const auto other = std::find_if(theirs.bodies.begin(), theirs.bodies.end(), same_name);
    ASSERT_NE(other, theirs.bodies.end()) << ours.bodies[a].name;
    const auto b = static_cast<std::size_t>(other - theirs.bodies.begin());
    const Vector3<double> difference =
        generated.formulations[0].solution.r_ddot[a] - published.formulations[0].solution.r_ddot[b];
    EXPECT_LT(difference.norm(), 1e-12);
  }
}

}  // namespace
}  // namespace trivium
