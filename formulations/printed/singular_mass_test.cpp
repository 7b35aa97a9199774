/// Bodies without inertia about an axis, and the metric that replaces a singular mass matrix.

#include "bodies/rotations/so3.hpp"
#include "bodies/testing/properties.hpp"
#include "formulations/side_by_side.hpp"
#include "formulations/testing/random_mechanism.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/testing/scene_builders.hpp"

namespace trivium {
namespace {

using test::distance;

/// A crank on the ground, and a slender rod along its x axis that is held at one end by the crank.
scenes::Scene rod(ConstraintType type) {
  scenes::Scene scene;
  scene.bodies = {test::body("crank", 1, {0.1, 0.1, 0.1}, {-0.5, 0, 0}),
                  test::body("rod", 2, {0, 0.3, 0.3}, {0.7, 0, 0})};
  const scenes::Vector3 y{0, 1, 0};
  scene.constraints = {
      test::joint(JointType::revolute, "A", test::side(scenes::ground, scenes::Vector3{-1, 0, 0}, y),
                  test::side(0, scenes::Vector3{-0.5, 0, 0}, y)),
      test::joint(type, "B", test::side(0, scenes::Vector3{0.5, 0, 0}, y),
                  {1,
                   scenes::Vector3{-0.7, 0, 0},
                   {},
                   type == JointType::universal ? scenes::Vector3{0, 0, 1} : y,
                   {}})};
  scene.effects = {test::gravity()};
  return scene;
}

TEST(SingularMass, ThatIsHeldByAJointIsNoError) {
  for (const auto type : {JointType::revolute, JointType::universal, JointType::fixed}) {
    auto scene = rod(type);
    if (type == JointType::fixed)
      scene.constraints[1].i.x = scene.constraints[1].j.x = scenes::Vector3{1, 0, 0};
    const RowAnalysis rows = analyse_rows(make_model<double>(scene));
    EXPECT_EQ(rows.rank, static_cast<int>(rows.unique.size()));
    EXPECT_GT(rows.mu.minCoeff(), 0);
    EXPECT_TRUE(std::isfinite(rows.kappa) && rows.E.allFinite());
  }
}

TEST(SingularMass, IsHeldByARowOfAnyScale) {
  auto scene = rod(JointType::universal);
  auto pin = test::joint(basic_type<CD>, "pin", test::side(scenes::ground), test::side(0));
  pin.direction = {0, 1e9, 0};
  scene.constraints.push_back(pin);
  EXPECT_EQ(analyse_rows(make_model<double>(scene)).rank,
            analyse_rows(make_model<double>(rod(JointType::universal))).rank);
}

TEST(SingularMass, IsHeldBesideAMassOfAnySize) {
  for (const double mass : {1e-14, 1e14}) {
    auto scene = rod(JointType::universal);
    scene.bodies[0].mass = mass;
    scene.bodies[0].inertia = scenes::Vector3{0.1 * mass, 0.1 * mass, 0.1 * mass};
    EXPECT_EQ(analyse_rows(make_model<double>(scene)).rank, 9);
  }
}

TEST(SingularMass, AboutATiltedAxisIsHeldBesideAMassOfAnySize) {
  // the body frame of the rod is rotated, so that the axis of the rod is not a body axis
  auto scene = rod(JointType::universal);
  const Matrix3<double> A = rotation_matrix<double>(Vector4<double>(0.8, 0.2, 0.4, 0.4).normalized());
  const auto turned = [&](const scenes::Vector3& v) {
    const Vector3<double> w = A.transpose() * Vector3<double>(v[0], v[1], v[2]);
    return scenes::Vector3{w[0], w[1], w[2]};
  };
  const Matrix3<double> J = A.transpose() * Vector3<double>(0, 0.3, 0.3).asDiagonal() * A;
  scenes::Matrix3 inertia;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) inertia[r][c] = J(std::min(r, c), std::max(r, c));
  scene.bodies[1].inertia = inertia;
  scene.bodies[1].orientation = scenes::EulerParameters{{0.8, 0.2, 0.4, 0.4}};
  scene.constraints[1].j.point = turned(*scene.constraints[1].j.point);
  scene.constraints[1].j.axis = turned(*scene.constraints[1].j.axis);
  for (const double mass : {1e-14, 1.0, 1e14}) {
    scene.bodies[0].mass = mass;
    scene.bodies[0].inertia = scenes::Vector3{0.1 * mass, 0.1 * mass, 0.1 * mass};
    EXPECT_EQ(analyse_rows(make_model<double>(scene)).rank, 9) << mass;
  }
}

TEST(SingularMass, ThatNothingHoldsIsAnErrorThatNamesTheBodyAndItsAxis) {
  try {
    analyse_rows(make_model<double>(rod(JointType::spherical)));
    FAIL() << "the rod may spin at any acceleration";
  } catch (const ModelError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("\"rod\""), std::string::npos) << message;
    EXPECT_TRUE(message.find("(1, 0, 0)") != std::string::npos ||
                message.find("(-1, 0, 0)") != std::string::npos)
        << message;
  }
}

TEST(SingularMass, WithoutAnyConstraintIsAnError) {
  scenes::Scene scene;
  scene.bodies = {test::body("rod", 2, {0, 0.3, 0.3})};
  EXPECT_THROW(analyse_rows(make_model<double>(scene)), ModelError);
}

TEST(Metric, IsTheMassMatrixWhereThatIsRegular) {
  TangentSystem s = [] {
    const auto scene = test::random_scene(3, {.bodies = 2});
    return tangent_system(make_mechanism<double>(scene), make_state<double>(scene));
  }();
  const MassMetric metric(s);
  EXPECT_TRUE(metric.mu().isZero(0));
  const MatrixX<double> half = metric.half_solve(MatrixX<double>::Identity(12, 12));
  MatrixX<double> M = MatrixX<double>::Zero(12, 12);
  for (int b = 0; b < 2; ++b) {
    M.block<3, 3>(6 * b, 6 * b).diagonal().setConstant(s.mass[b]);
    M.block<3, 3>(6 * b + 3, 6 * b + 3) = s.inertia[b];
  }
  EXPECT_LE(distance(half * M * half.transpose(), MatrixX<double>::Identity(12, 12)), 1e-13);
  const MatrixX<double> both = metric.half_solve_transposed(half);
  EXPECT_LE(distance(both * M, MatrixX<double>::Identity(12, 12)), 1e-13);
}

}  // namespace
}  // namespace trivium
