/// Springs, dampers and actuators: forces and torques, angles over full revolutions, conservation of energy.

#include <gtest/gtest.h>

#include <cmath>

#include "bodies/rotations/so3.hpp"
#include "bodies/testing/properties.hpp"
#include "effects/effect_list.hpp"

namespace trivium {
namespace {

using test::distance;
using TF = TimeFunction;

/// A body that moves along the x axis, for a spring between the origin and the body.
struct OnALine {
  std::vector<RigidBody<double>> bodies{1};
  std::vector<BodyMotion<double>> motion{2};
  OnALine(double x, double x_dot) {
    motion[0].r[0] = x;
    motion[0].r_dot[0] = x_dot;
  }
  double force_on_body(const SpringDamper<double>& s) const {
    std::vector<Wrench<double>> wrenches(2);
    s.apply({bodies, motion, 0.0}, wrenches);
    EXPECT_EQ(wrenches[0].F, -wrenches[1].F);
    return wrenches[0].F[0];
  }
};
SpringDamper<double> spring_from_origin(double k, double c, double l0, const TF& h) {
  return {"rope", {1}, {0}, k, c, l0, h};
}

TEST(SpringDamper, PullsWithItsTension) {
  EXPECT_DOUBLE_EQ(OnALine(2, 0).force_on_body(spring_from_origin(10, 0, 1.5, {})), -5);
  EXPECT_DOUBLE_EQ(OnALine(1, 0).force_on_body(spring_from_origin(10, 0, 1.5, {})), 5);
  EXPECT_DOUBLE_EQ(OnALine(2, 3).force_on_body(spring_from_origin(0, 4, 0, {})), -12);
  EXPECT_DOUBLE_EQ(OnALine(2, 0).force_on_body(spring_from_origin(0, 0, 0, 7.0)), -7);
}

TEST(SpringDamper, OfNoLengthIsAnErrorThatNamesItUnlessItsForceVanishes) {
  const OnALine together(0, 1);
  EXPECT_EQ(together.force_on_body(spring_from_origin(10, 0, 0, {})), 0);
  for (const auto& s : {spring_from_origin(10, 0, 1, {}), spring_from_origin(0, 2, 0, {}),
                        spring_from_origin(0, 0, 0, 3.0)}) {
    try {
      together.force_on_body(s);
      ADD_FAILURE() << "a force without a direction";
    } catch (const ModelError& error) {
      const std::string message = error.what();
      for (const char* part : {"\"rope\"", "coincide", "t = 0", "move an end"})
        EXPECT_NE(message.find(part), std::string::npos) << message;
    }
  }
}

/// A body j that is rotated by `angle` [rad] about the z axis of the ground.
struct OnAnAxis {
  std::vector<RigidBody<double>> bodies{1};
  std::vector<BodyMotion<double>> motion{2};
  OnAnAxis(double angle, double rate) {
    motion[0].A = axis_rotation(2, angle);
    motion[0].omega_bar[2] = rate;
  }
  EffectView<double> view() const { return {bodies, motion, 0.0}; }
  double torque_on_j(const TorsionalSpringDamper<double>& s) const {
    std::vector<Wrench<double>> wrenches(2);
    s.apply(view(), wrenches);
    EXPECT_LE(distance(wrenches[0].n_bar, -wrenches[1].n_bar), 1e-15);
    return wrenches[0].n_bar[2];
  }
};
TorsionalSpringDamper<double> about_z(double k, double c, double theta0, const TF& h) {
  const Vector3<double> x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  return {"", {0, 1, 0, x, y, z, x}, k, c, theta0, h};
}

TEST(Effects, AreConservativeWhereTheyGiveBackWhatTheyStore) {
  const TF number = 3.0, function = TF::Polynomial{{0, 1}};
  EXPECT_TRUE(Gravity<double>{}.is_conservative());
  EXPECT_TRUE((Force<double>{"", 0, Vector3<double>::Zero(), {number, number, number}}.is_conservative()));
  EXPECT_FALSE((Force<double>{"", 0, Vector3<double>::Zero(), {number, function, number}}.is_conservative()));
  EXPECT_FALSE((Force<double>{"", 0, Vector3<double>::Zero(), {number, number, number}, ComponentFrame::body}
                    .is_conservative()));
  EXPECT_FALSE((Torque<double>{"", 0, {number, number, number}}.is_conservative()));
  EXPECT_TRUE(about_z(10, 0, 0.2, {}).is_conservative());
  EXPECT_FALSE(about_z(10, 1, 0.2, {}).is_conservative());
  EXPECT_FALSE(about_z(10, 0, 0.2, number).is_conservative());
  EXPECT_TRUE((SpringDamper<double>{"", {0}, {1}, 10, 0, 1, {}}.is_conservative()));
  EXPECT_FALSE((SpringDamper<double>{"", {0}, {1}, 10, 1, 1, {}}.is_conservative()));
}

TEST(Effects, TakeFromStoredEnergyAllButTheWorkOfDampersAndActuators) {
  EXPECT_DOUBLE_EQ(about_z(10, 4, 0.2, 7.0).nonconservative_power(OnAnAxis(0.5, 3).view()), -(4 * 3 + 7) * 3);
  EXPECT_DOUBLE_EQ(about_z(10, 0, 0.2, {}).nonconservative_power(OnAnAxis(0.5, 3).view()), 0);
  EXPECT_DOUBLE_EQ(about_z(10, 0, 0.2, {}).longest_step(OnAnAxis(0.5, 3).view()), 1.0 / 3);
  EXPECT_GT(about_z(10, 0, 0.2, {}).longest_step(OnAnAxis(0.5, 0).view()), 1e300);
}

TEST(Effects, AStepThatNobodyKnowsIsNoLongStep) {
  const OnAnAxis lost(0.5, std::numeric_limits<double>::quiet_NaN());
  Effects<double> effects;
  effects.add(about_z(10, 0, 0.2, {}));
  EXPECT_TRUE(std::isnan(effects.longest_step(lost.view())));
}

TEST(TorsionalSpringDamper, DrivesThetaBackAndAPositiveActuatorDrivesItDown) {
  EXPECT_DOUBLE_EQ(OnAnAxis(0.5, 0).torque_on_j(about_z(10, 0, 0.2, {})), -3);
  EXPECT_DOUBLE_EQ(OnAnAxis(0.1, 0).torque_on_j(about_z(10, 0, 0.2, {})), 1);
  EXPECT_DOUBLE_EQ(OnAnAxis(0.5, 3).torque_on_j(about_z(0, 4, 0, {})), -12);
  EXPECT_DOUBLE_EQ(OnAnAxis(0.5, 0).torque_on_j(about_z(0, 0, 0, 7.0)), -7);
}

TEST(TorsionalSpringDamper, AngleLiesInTheHalfOpenTurnUntilItIsFollowed) {
  const double pi = std::acos(-1.0);
  auto s = about_z(1, 0, 0, {});
  for (const double angle : {-3.0, -0.5, 0.0, 0.5, 3.0}) {
    EXPECT_NEAR(s.angle.value(OnAnAxis(angle, 0).view()), angle, 1e-15);
    EXPECT_NEAR(s.angle.value(OnAnAxis(angle + 2 * pi, 0).view()), angle, 1e-14);
  }
  for (double angle = 0; angle < 13; angle += 3) {
    s.follow(OnAnAxis(angle, 0).view());
    EXPECT_NEAR(s.angle.value(OnAnAxis(angle, 0).view()), angle, 1e-14);
  }
  EXPECT_NEAR(s.angle.value(OnAnAxis(0.5, 0).view()), 0.5 + 4 * pi, 1e-14);
}

TEST(TorsionalSpringDamper, HalfATurnIsPlusPi) {
  const double pi = std::acos(-1.0);
  for (const double zero : {0.0, -0.0}) {  // the result must not depend on the sign of zeros in A
    OnAnAxis half(0, 0);
    half.motion[0].A << -1, zero, zero, zero, -1, zero, zero, zero, 1;
    EXPECT_EQ(about_z(1, 0, 0, {}).angle.value(half.view()), pi);
  }
}

}  // namespace
}  // namespace trivium
