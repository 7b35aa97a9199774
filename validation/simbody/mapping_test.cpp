/// Sign and factor of every mapping in multiplier_signs.hpp, on problems with solutions by hand.

#include <gtest/gtest.h>

#include <cmath>

#include "validation/simbody/comparison.hpp"
#include "validation/simbody/solve.hpp"
#include "validation/simbody/testing/one_body_scene.hpp"
#include "validation/simbody/translation.hpp"

namespace trivium {
namespace {

using namespace one_body;
using simbody::Way;

const std::vector<Way> all_ways{Way::mobilizers, Way::free_bodies, Way::built_in};

void expect_lambda(const scenes::Scene& scene, const std::vector<double>& lambda) {
  for (const Way way : {Way::free_bodies, Way::built_in}) {
    const simbody::Answer answer = simbody::solve(to_simbody(scene, 0), way);
    ASSERT_EQ(answer.lambda.size(), lambda.size());
    for (std::size_t k = 0; k < lambda.size(); ++k)
      EXPECT_NEAR(answer.lambda[k], lambda[k], 1e-12) << name_of(way) << ", row " << k;
    EXPECT_LT(answer.jacobian_defect, 1e-14) << name_of(way);
  }
}

TEST(SimbodyMapping, BallHoldsTheWeight) {
  scenes::Scene scene = scene_at_rest();
  hold(scene, JointType::spherical, {}, {});
  expect_lambda(scene, {0, 0, -m * g});
}

TEST(SimbodyMapping, RodIsDividedByTwiceItsLength) {
  const double length = 0.7;
  scenes::Scene scene = scene_at_rest();
  scene.bodies[0].position = {0, 0, -length};
  hold(scene, JointType::distance, {}, {}).distance = length;
  expect_lambda(scene, {m * g / (2 * length)});  // 2 d lambda = F with d = (0, 0, -length)
}

TEST(SimbodyMapping, PointInPlaneIsDividedByTheNormal) {
  scenes::Scene scene = scene_at_rest();
  hold(scene, basic_type<DP2>, along({0, 0, 4}), {});
  expect_lambda(scene, {-m * g / 4});
}

TEST(SimbodyMapping, GlobalDirectionIsAPlaneOnGround) {
  scenes::Scene scene = scene_at_rest();
  scenes::Constraint& cd = hold(scene, basic_type<CD>, at({0.1, 0.2, -0.5}), {});
  cd.direction = {0, 0, 3};
  cd.f = 1.5;
  expect_lambda(scene, {-m * g / 3});
}

TEST(SimbodyMapping, ConstantAngleIsDividedByBothVectors) {
  scenes::Scene scene = scene_at_rest();
  scene.effects.push_back(torque(0, 0, 7));
  hold(scene, basic_type<DP1>, along({2, 0, 0}), along({0, 3, 0}));
  expect_lambda(scene, {-7.0 / 6});  // a_i . (theta x a_j) = -6 theta_z
}

TEST(SimbodyMapping, WeldRowsCarryTheTorque) {
  scenes::Scene scene = scene_at_rest();
  scene.effects.push_back(torque(3, 5, 7));
  hold(scene, JointType::fixed, upright, upright);
  expect_lambda(scene, {0, 0, -m * g, 5, -3, -7});
}

TEST(SimbodyMapping, ConstantOrientationRowsCarryTheTorque) {
  scenes::Scene scene = scene_at_rest();
  scene.effects.push_back(torque(3, 5, 7));
  scene.effects.push_back(Force<double>{"", 0, Vector3<double>::Zero(), {11, 13, 0}});
  hold(scene, JointType::translational, upright, upright);
  expect_lambda(scene, {5, -3, 11, 13, -7});
}

/// The driver's torque on body j about z is -lambda, where alpha and not alpha + pi is reached: alpha'' J = n
/// - lambda.
TEST(SimbodyMapping, DriverTorqueIsMinusLambda) {
  scenes::Scene scene = scene_at_rest();
  scene.effects.push_back(torque(0, 0, 7));
  hold(scene, JointType::revolute, upright, upright);
  hold(scene, JointType::rotation_driver, upright, upright).angle =
      TimeFunction::Polynomial{{0, 0, 2}};  // alpha'' = 4
  expect_lambda(scene, {0, 0, -m * g, 0, 0, 7 - 0.5 * 4});
}

/// theta is the angle about y from the lowest position: r = -L (sin, 0, cos), (Jyy + m L^2) theta'' = -m g L
/// sin. The reaction on the body is m (r'' - g).
TEST(SimbodyMapping, PendulumReactionByHand) {
  const double L = 0.8, theta = 0.6, rate = 1.7;
  const double s = std::sin(theta), c = std::cos(theta);
  scenes::Scene scene = scene_at_rest();
  scene.bodies[0].position = {-L * s, 0, -L * c};
  scene.bodies[0].orientation = scenes::AxisAngle{{0, 1, 0}, theta};
  scene.bodies[0].velocity = {-L * c * rate, 0, L * s * rate};
  scene.bodies[0].angular_velocity = {0, rate, 0};
  hold(scene, JointType::revolute, hinge({0, 0, 0}, {0, 1, 0}, {0, 0, 1}),
       hinge({0, 0, L}, {0, 1, 0}, {0, 0, 1}));

  const double theta_ddot = -m * g * L * s / (0.4 + m * L * L);
  const double x_ddot = -L * c * theta_ddot + L * s * rate * rate;
  const double z_ddot = L * s * theta_ddot + L * c * rate * rate;
  for (const Way way : all_ways) {
    SCOPED_TRACE(name_of(way));
    const simbody::Answer answer = simbody::solve(to_simbody(scene, 0), way);
    EXPECT_NEAR(answer.omega_bar_dot[0][1], theta_ddot, 1e-12);
    EXPECT_NEAR(answer.r_ddot[0][0], x_ddot, 1e-12);
    EXPECT_NEAR(answer.r_ddot[0][2], z_ddot, 1e-12);
    EXPECT_NEAR(answer.reactions_on_j[0].force[0], m * x_ddot, 1e-12);
    EXPECT_NEAR(answer.reactions_on_j[0].force[1], 0, 1e-12);
    EXPECT_NEAR(answer.reactions_on_j[0].force[2], m * (z_ddot + g), 1e-12);
    for (const double n : answer.reactions_on_j[0].torque) EXPECT_NEAR(n, 0, 1e-12);
    if (way == Way::mobilizers) continue;
    EXPECT_NEAR(answer.lambda[0], -m * x_ddot, 1e-12);
    EXPECT_NEAR(answer.lambda[2], -m * (z_ddot + g), 1e-12);
  }
}

/// A CD acts at P_i on body i and at P_j on body j, along its own direction. About one point, the torques
/// differ by the moment of the offset. If i is the body, the force c lambda on it passes through its centre
/// of mass.
TEST(SimbodyMapping, DirectedRowActsAtThePointOfEachBody) {
  scenes::Scene scene = scene_at_rest();
  scenes::Constraint& cd = hold(scene, basic_type<CD>, at({1, 2, 3}), {});
  cd.direction = {0, 0, 2};
  cd.f = 6;
  std::swap(cd.i, cd.j);
  for (const Way way : {Way::free_bodies, Way::built_in}) {
    SCOPED_TRACE(name_of(way));
    const simbody::Answer answer = simbody::solve(to_simbody(scene, 0), way);
    const simbody::Reaction &on_i = answer.reactions_on_i[0], &on_j = answer.reactions_on_j[0];
    EXPECT_NEAR(on_i.force[2], m * g, 1e-12);
    EXPECT_NEAR(on_j.force[2], -m * g, 1e-12);
    for (const double n : on_i.torque) EXPECT_NEAR(n, 0, 1e-12);
    EXPECT_NEAR(on_j.torque[0], -2 * m * g, 1e-12);  // (1, 2, 3) x (0, 0, -m g)
    EXPECT_NEAR(on_j.torque[1], m * g, 1e-12);
  }
}

/// A second hinge on the same axis adds no independent row and does not change the acceleration.
TEST(SimbodyMapping, IdleRowsAreDisabled) {
  scenes::Scene scene = scene_at_rest();
  scene.bodies[0].position = {0.4, 0, 0.1};
  hold(scene, JointType::revolute, upright, hinge({-0.4, 0, -0.1}, {0, 0, 1}, {1, 0, 0}));
  hold(scene, JointType::revolute, hinge({0, 0, 1}, {0, 0, 1}, {1, 0, 0}),
       hinge({-0.4, 0, 0.9}, {0, 0, 1}, {1, 0, 0}));
  scene.effects.push_back(torque(1, 2, 3));
  const simbody::Answer answer = simbody::solve(to_simbody(scene, 0), Way::mobilizers);
  EXPECT_EQ(answer.idle_rows, 5);
  EXPECT_EQ(answer.constraint_rows, 0);
  EXPECT_NEAR(answer.omega_bar_dot[0][2], 3 / (0.5 + m * 0.4 * 0.4), 1e-12);
}

TEST(SimbodyModel, RefusesAnUnphysicalInertiaAndComparesTheTwin) {
  scenes::Scene scene = scene_at_rest();
  hold(scene, JointType::fixed, upright, upright);
  for (const scenes::Vector3 inertia : {scenes::Vector3{0.1, 0.1, 0.9}, scenes::Vector3{0, 0, 0.9}}) {
    scene.bodies[0].inertia = inertia;
    for (const SimbodyComparison& c : compare_with_simbody({scene.name, scene, 0.0})) {
      EXPECT_TRUE(c.twin);
      EXPECT_NE(c.refusal.find("triangle inequality"), std::string::npos) << c.refusal;
      EXPECT_EQ(c.refusal.find('\n'), std::string::npos);
      EXPECT_TRUE(c.agrees());
    }
  }
}

/// Without a mobilizer all bodies would be free, as in the way free_bodies.
TEST(SimbodyComparison, IsNotPossibleWithMobilizersWhereNoJointBecomesOne) {
  scenes::Scene scene = scene_at_rest();
  scenes::Constraint& cd = hold(scene, basic_type<CD>, at({0, 0, 0}), {});
  cd.direction = {0, 0, 1};
  for (const bool hinged : {false, true}) {
    if (hinged) hold(scene, JointType::spherical, {}, {});
    for (const SimbodyComparison& c : compare_with_simbody({scene.name, scene, 0.0})) {
      SCOPED_TRACE(name_of(c.way));
      const bool possible = hinged || c.way != Way::mobilizers;
      EXPECT_EQ(c.possible, possible);
      EXPECT_EQ(c.compared(), possible);
      EXPECT_EQ(c.agrees(), possible);
      EXPECT_TRUE(c.error.empty());
    }
  }
}

/// A CD in addition to a weld is redundant. Its multiplier of least norm is not zero, and must appear in the
/// reaction on the body, whichever end of the CD the body is.
TEST(SimbodyComparison, ReactionsOfADirectedRowAgreeOnEitherEnd) {
  for (const bool swapped : {false, true}) {
    SCOPED_TRACE(swapped);
    scenes::Scene scene = scene_at_rest();
    scenes::Constraint& cd = hold(scene, basic_type<CD>, at({1, 2, 3}), {});
    cd.direction = {1, 0.5, 0.2};
    cd.f = swapped ? 2.6 : -2.6;
    if (swapped) std::swap(cd.i, cd.j);
    hold(scene, JointType::fixed, upright, upright);
    for (const SimbodyComparison& c : compare_with_simbody({scene.name, scene, 0.0})) {
      EXPECT_TRUE(c.agrees()) << name_of(c.way);
      EXPECT_LT(c.worst().reaction, 1e-13) << name_of(c.way);
    }
  }
}

TEST(SimbodyComparison, AgreesWithinTheBoundAndOnlyWhenSolved) {
  SimbodyComparison c;
  c.formulations.resize(2);
  for (double SimbodyDistance::*difference :
       {&SimbodyDistance::acceleration, &SimbodyDistance::lambda, &SimbodyDistance::reaction}) {
    c.formulations[1].*difference = 1e-11;
    EXPECT_TRUE(c.agrees());
    c.formulations[1].*difference = 2e-10;
    EXPECT_FALSE(c.agrees());
    c.kappa = 1e6;  // 100 u kappa = 1.1e-8
    EXPECT_TRUE(c.agrees());
    c.kappa = 1;
    c.formulations[1].*difference = 0;
  }
  c.formulations[0].error = "singular";
  EXPECT_FALSE(c.solved());
  EXPECT_FALSE(c.agrees());
}

}  // namespace
}  // namespace trivium
