/// Reactions computed by hand, in every formulation: sign, point and frame, on both bodies.

#include "formulations/joint_reaction.hpp"

#include "bodies/rotations/so3.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "formulations/testing/printed_solution.hpp"
#include "formulations/testing/solve_scene.hpp"
#include "scenes/testing/scene_builders.hpp"

namespace trivium {
namespace {

using test::distance;
using Vec = Vector3<double>;

template <class F>
class Reactions : public testing::Test {};
TYPED_TEST_SUITE(Reactions, test::AllFormulations<double>, test::FormulationNames);

template <class F>
struct Solved : test::Solved<F> {
  using test::Solved<F>::Solved;
  /// Reaction in the global frame, about the body's centre of mass.
  Reaction<double> on(End end, int joint = 0) const {
    return joint_reaction<F>(this->solver.equations(), this->mechanism.joints[joint], this->u.lambda, end);
  }
  Vec joint_point(int joint = 0) const {
    return trivium::joint_point<F>(this->solver.equations(), this->mechanism.joints[joint]);
  }
};

void expect_vector(const Vec& found, const Vec& expected) {
  EXPECT_LE(distance(found, expected), 1e-12 * (1 + expected.norm()))
      << "found " << found.transpose() << ", expected " << expected.transpose();
}

constexpr double m = 3, g = 9.81, L = 0.8;

/// A body at `position` joined to the ground at the origin, about the axis y.
scenes::Scene held_at_origin(ConstraintType type, const scenes::Vector3& position,
                             const scenes::Vector3& inertia = {0.3, 0.4, 0.5}) {
  scenes::Scene scene;
  scene.bodies = {test::body("body", m, inertia, position)};
  const scenes::Vector3 y{0, 1, 0}, x{1, 0, 0};
  scene.constraints = {
      test::joint(type, "joint", test::side(scenes::ground, scenes::Vector3{}, y, x),
                  test::side(0, scenes::Vector3{-position[0], -position[1], -position[2]}, y, x))};
  scene.effects = {test::gravity(g)};
  return scene;
}

TYPED_TEST(Reactions, APendulumHangingStillIsHeldUp) {
  const Solved<TypeParam> s(held_at_origin(JointType::revolute, {0, 0, -L}));
  const Reaction<double> on_body = s.on(End::j).about(s.joint_point());
  expect_vector(on_body.force, {0, 0, m * g});
  expect_vector(on_body.torque, Vec::Zero());
  expect_vector(on_body.point, Vec::Zero());
  const Reaction<double> on_ground = s.on(End::i);
  expect_vector(on_ground.force, {0, 0, -m * g});
  expect_vector(on_ground.torque, Vec::Zero());
}

TYPED_TEST(Reactions, AHorizontalCantileverIsHeldByForceAndTorque) {
  const Solved<TypeParam> s(held_at_origin(JointType::fixed, {L, 0, 0}));
  const Reaction<double> at_wall = s.on(End::j).about(s.joint_point());
  expect_vector(at_wall.force, {0, 0, m * g});
  expect_vector(at_wall.torque, {0, -m * g * L, 0});
  // about the centre of mass of the body the reaction has no torque
  expect_vector(s.on(End::j).torque, Vec::Zero());
  expect_vector(s.on(End::j).point, {L, 0, 0});
  // the wall has the opposite reaction
  expect_vector(s.on(End::i).force, {0, 0, -m * g});
  expect_vector(s.on(End::i).torque, {0, m * g * L, 0});
}

TYPED_TEST(Reactions, ASpinningRotorIsPulledToItsAxis) {
  constexpr double omega = 7, e = 0.2;
  auto scene = held_at_origin(JointType::revolute, {e, 0, 0});
  scene.bodies[0].angular_velocity = {0, omega, 0};
  scene.bodies[0].velocity = {0, 0, -omega * e};
  scene.effects.clear();
  const Solved<TypeParam> s(scene);
  expect_vector(s.on(End::j).about(s.joint_point()).force, {-m * omega * omega * e, 0, 0});
  expect_vector(s.on(End::j).about(s.joint_point()).torque, Vec::Zero());
}

TYPED_TEST(Reactions, AFallingPendulumIsHeldByHalfItsFall) {
  // released from the horizontal: alpha = m g L / (J + m L^2), and the pin carries m (g - L alpha)
  const double J = 0.4, alpha = m * g * L / (J + m * L * L);
  const Solved<TypeParam> s(held_at_origin(JointType::revolute, {L, 0, 0}));
  expect_vector(s.on(End::j).force, {0, 0, m * (g - L * alpha)});
  expect_vector(s.on(End::j).about(s.joint_point()).torque, Vec::Zero());
  expect_vector(s.u.body[0].r_ddot, {0, 0, -L * alpha});
}

TYPED_TEST(Reactions, ADriverTurnsBodyJWithMinusLambda) {
  auto scene = held_at_origin(JointType::revolute, {0, 0, -L});
  auto driver = scene.constraints[0];
  driver.type = JointType::rotation_driver;
  driver.name = "motor";
  const double alpha_ddot = 1.7, J = 0.4;
  driver.angle = TimeFunction::Polynomial{{0, 0, alpha_ddot / 2}};
  scene.constraints.push_back(driver);
  const Solved<TypeParam> s(scene);
  const double torque = (J + m * L * L) * alpha_ddot;  // the weight acts through the axis and has no moment
  expect_vector(s.on(End::j, 1).torque, {0, torque, 0});
  expect_vector(s.on(End::j, 1).force, Vec::Zero());
  expect_vector(s.on(End::i, 1).torque, {0, -torque, 0});
  EXPECT_NEAR(s.u.lambda[5], -torque, 1e-12);
}

TYPED_TEST(Reactions, ABodyOfAChainCarriesAllBelowIt) {
  scenes::Scene scene;
  const auto ball = [](const char* name, int i, int j) {
    return test::joint(JointType::spherical, name,
                       test::side(i, scenes::Vector3{0, 0, i == scenes::ground ? 0.0 : -0.5}),
                       test::side(j, scenes::Vector3{0, 0, 0.5}));
  };
  for (int b = 0; b < 3; ++b) {
    scene.bodies.push_back(
        test::body("link " + std::to_string(b), b + 1.0, {0.1, 0.1, 0.1}, {0, 0, -b - 0.5}));
    scene.constraints.push_back(ball(b == 0 ? "a" : b == 1 ? "b" : "c", b - 1, b));
  }
  scene.effects = {test::gravity(10)};
  const Solved<TypeParam> s(scene);
  for (int b = 0; b < 3; ++b) {
    const double below = b == 0 ? 60 : b == 1 ? 50 : 30;
    expect_vector(s.on(End::j, b).force, {0, 0, below});
    expect_vector(s.on(End::i, b).force, {0, 0, -below});
  }
}

TEST(Reaction, AboutAnotherPointIsTheSameWrench) {
  test::Random random(121);
  const Reaction<double> one{random.vector<double, 3>(), random.vector<double, 3>(),
                             random.vector<double, 3>()};
  const Vec other = random.vector<double, 3>();
  const Reaction<double> two = one.about(other);
  // equal power in any motion of the body
  const Vec omega = random.vector<double, 3>(), v = random.vector<double, 3>();
  const auto power = [&](const Reaction<double>& r) {
    return r.force.dot(v + omega.cross(r.point)) + r.torque.dot(omega);
  };
  EXPECT_NEAR(power(two), power(one), 1e-14);
  EXPECT_EQ(two.point, other);
  expect_vector(two.about(one.point).torque, one.torque);
}

TEST(Reaction, InAnotherFrameHasTheComponentsOfThatFrame) {
  const Reaction<double> global{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  // the x axis of this frame is the global y axis, its y axis the negative global x axis
  const Reaction<double> turned = global.in_frame(axis_rotation(2, std::acos(0.0)));
  expect_vector(turned.force, {2, -1, 3});
  expect_vector(turned.torque, {5, -4, 6});
  expect_vector(turned.point, {8, -7, 9});
}

TEST(SideBySide, ReportsReactionsOnBodyJAboutTheJointsPoint) {
  const auto result = test::solve_scene<double>(held_at_origin(JointType::fixed, {L, 0, 0}));
  ASSERT_EQ(result.formulations.size(), formulation_names().size());
  for (const auto& formulation : result.formulations) {
    expect_vector(formulation.reactions[0].force, {0, 0, m * g});
    expect_vector(formulation.reactions[0].torque, {0, -m * g * L, 0});
    expect_vector(formulation.reactions[0].point, Vec::Zero());
  }
}

}  // namespace
}  // namespace trivium
