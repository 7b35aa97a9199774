/// Compares the ways of rebuilding a scene, and Trivium's formulations, on every type of joint.

#include <gtest/gtest.h>

#include "bodies/rotations/so3.hpp"
#include "mechanism/mechanism.hpp"
#include "scenes/format/scene_keys.hpp"
#include "validation/simbody/comparison.hpp"
#include "validation/simbody/testing/one_body_scene.hpp"

namespace trivium {
namespace {

using namespace one_body;
using simbody::Way;

/// A body that moves on one joint of any type. All frames are oblique, and the ground is body i or body j.
struct JointCase {
  ConstraintType type;
  scenes::Vector3 sliding, turning;  ///< velocities along and about u, v, z of the joint
  bool ground_is_j;

  friend void PrintTo(const JointCase& joint, std::ostream* out) {
    *out << scenes::shape_of(joint.type).name() << (joint.ground_is_j ? "_to_ground" : "_from_ground");
  }
};

class EveryJoint : public testing::TestWithParam<JointCase> {};

scenes::Vector3 plain(const Vector3<double>& v) { return {v[0], v[1], v[2]}; }

scenes::Scene on_joint(const JointCase& joint) {
  const Vector4<double> p = Vector4<double>(0.7, -0.3, 0.5, 0.2).normalized();
  const Matrix3<double> A = rotation_matrix(p);
  const auto ground_frame = joint_frame<double>({0.3, -0.2, 0.5}, {0.4, 1, -0.3}, {1, 0.2, 0.1});
  const Vector3<double> r(0.6, 0.1, -0.4);
  Matrix3<double> axes;
  axes << ground_frame.u, ground_frame.v, ground_frame.z;
  scenes::Scene scene = scene_at_rest();
  scenes::Body& body = scene.bodies[0];
  body.inertia = scenes::Matrix3{{{0.3, 0.02, -0.01}, {0.02, 0.4, 0.03}, {-0.01, 0.03, 0.5}}};
  body.position = plain(r);
  body.orientation = scenes::EulerParameters{{p[0], p[1], p[2], p[3]}};
  const Vector3<double> omega = axes * Vector3<double>(joint.turning.data());
  const Vector3<double> slide = axes * Vector3<double>(joint.sliding.data());
  body.angular_velocity = plain(A.transpose() * omega);
  body.velocity = plain(slide + omega.cross(r - ground_frame.point));

  const bool universal = joint.type == JointType::universal;
  const Vector3<double> z = A.transpose() * (universal ? ground_frame.u : ground_frame.z);
  const Vector3<double> x = A.transpose() * (universal ? ground_frame.v : ground_frame.u);
  const scenes::Side on_ground =
      hinge(plain(ground_frame.point), plain(ground_frame.z), plain(ground_frame.u));
  const scenes::Side on_body = hinge(plain(A.transpose() * (ground_frame.point - r)), plain(z), plain(x));
  scenes::Constraint& c = hold(scene, joint.type, on_ground, on_body);
  if (joint.ground_is_j) std::swap(c.i, c.j);
  Torque<double> twist = torque(0.7, -1.3, 2.1);
  twist.frame = ComponentFrame::body;
  scene.effects.push_back(twist);
  SpringDamper<double> spring;
  spring.i = {scenes::ground, {1, 1, 1}};
  spring.j = {0, {0.2, 0.1, 0}};
  spring.stiffness = 30;
  spring.damping = 2;
  spring.free_length = 0.4;
  spring.actuator = 5;
  scene.effects.push_back(spring);
  if (properties_of(joint.type).has_an_angle)
    scene.effects.push_back(TorsionalSpringDamper<double>{"", {0}, 4, 0.5, 0.3, 0.2});
  return scene;
}

TEST_P(EveryJoint, AgreesInEveryWay) {
  for (const SimbodyComparison& c : compare_with_simbody({"joint", on_joint(GetParam()), 0.0})) {
    EXPECT_FALSE(c.twin) << c.refusal;
    EXPECT_LT(c.pose_defect, 1e-14);
    EXPECT_TRUE(c.agrees()) << name_of(c.way);
    EXPECT_LT(c.worst().acceleration, 1e-13) << name_of(c.way);
    EXPECT_LT(c.worst().lambda, 1e-13) << name_of(c.way);
    EXPECT_LT(c.worst().reaction, 1e-13) << name_of(c.way);
    EXPECT_EQ(c.mobilizers, c.way == Way::mobilizers ? 1 : 0);
  }
}

std::vector<JointCase> joint_cases() {
  std::vector<JointCase> cases;
  for (const bool swapped : {false, true}) {
    cases.push_back({JointType::revolute, {0, 0, 0}, {0, 0, 1.3}, swapped});
    cases.push_back({JointType::universal, {0, 0, 0}, {0.8, 0, -1.1}, swapped});
    cases.push_back({JointType::spherical, {0, 0, 0}, {0.8, -0.4, -1.1}, swapped});
    cases.push_back({JointType::cylindrical, {0, 0, 0.9}, {0, 0, 1.3}, swapped});
    cases.push_back({JointType::translational, {0, 0, 0.9}, {0, 0, 0}, swapped});
    cases.push_back({JointType::planar, {0.5, -0.7, 0}, {0, 0, 1.3}, swapped});
    cases.push_back({JointType::fixed, {0, 0, 0}, {0, 0, 0}, swapped});
  }
  return cases;
}

INSTANTIATE_TEST_SUITE_P(, EveryJoint, testing::ValuesIn(joint_cases()), testing::PrintToStringParamName());

}  // namespace
}  // namespace trivium
