/// Slender rods in Simbody: which motions have no mass, and which scene is compared in this case.

#include "validation/simbody/massless_motion.hpp"

#include <gtest/gtest.h>

#include "bodies/rotations/so3.hpp"
#include "formulations/analysis/row_analysis.hpp"
#include "scenes/make_mechanism.hpp"
#include "validation/simbody/comparison.hpp"
#include "validation/simbody/testing/one_body_scene.hpp"
#include "validation/simbody/translation.hpp"

namespace trivium {
namespace {

using namespace one_body;
using simbody::Way;

const Vector4<double> p = Vector4<double>(0.8, 0.3, -0.4, 0.2).normalized();
scenes::Vector3 global(const Vector3<double>& in_rod) {
  const Vector3<double> v = rotation_matrix(p) * in_rod;
  return {v[0], v[1], v[2]};
}

/// A slender rod along its z axis, with one end at the origin. The rod is rotated, so that its inertia in the
/// global frame is singular only up to rounding.
scenes::Scene rod() {
  scenes::Scene scene = scene_at_rest();
  scenes::Body& body = scene.bodies[0];
  body.inertia = scenes::Vector3{0.3, 0.3, 0};
  body.orientation = scenes::EulerParameters{{p[0], p[1], p[2], p[3]}};
  body.position = global({0, 0, 0.6});
  return scene;
}

/// A rod with one end fixed to the ground by a spherical joint, and a dp1 that fixes its spin.
scenes::Scene spherical_rod_with_its_spin_held() {
  scenes::Scene scene = rod();
  hold(scene, JointType::spherical, {}, at({0, 0, -0.6}));
  hold(scene, basic_type<DP1>, along(global({0.8, 0, 0.6})), along({0, 1, 0}));
  return scene;
}

scenes::Scene rod_on_pin_about(const Vector3<double>& axis, const scenes::Vector3& point) {
  scenes::Scene scene = rod();
  const Vector3<double> x = axis.unitOrthogonal();
  const scenes::Vector3 in_ground =
      global(Vector3<double>(0, 0, 0.6) + Vector3<double>(point[0], point[1], point[2]));
  hold(scene, JointType::revolute, hinge(in_ground, global(axis), global(x)),
       hinge(point, {axis[0], axis[1], axis[2]}, {x[0], x[1], x[2]}));
  return scene;
}

std::optional<std::string> massless_motion(const scenes::Scene& scene, Way way) {
  const auto mechanism = make_mechanism<double>(scene);
  const auto state = make_state<double>(scene);
  return massless_motion(mechanism, tangent_system(mechanism, state).Phi,
                         simbody::mobilizers(to_simbody(scene, 0), way));
}

TEST(MasslessMotion, ARodThatFloatsFreelySpins) {
  EXPECT_EQ(massless_motion(rod(), Way::free_bodies), "body");
  EXPECT_EQ(massless_motion(spherical_rod_with_its_spin_held(), Way::built_in), "body");
}

TEST(MasslessMotion, AMomentWithinTheFormatsToleranceIsNone) {
  scenes::Scene scene = rod();
  scene.bodies[0].inertia = scenes::Vector3{0.3, 0.3, 0.5e-12};
  EXPECT_TRUE(massless_motion(scene, Way::free_bodies));
  scene.bodies[0].inertia = scenes::Vector3{0.3, 0.3, 0.7e-12};
  EXPECT_FALSE(massless_motion(scene, Way::free_bodies));
}

TEST(MasslessMotion, AMobilizerTakesTheSpinAway) {
  EXPECT_FALSE(massless_motion(rod_on_pin_about({0, 1, 0}, {0, 0, -0.6}), Way::mobilizers));
  EXPECT_TRUE(massless_motion(rod_on_pin_about({0, 1, 0}, {0, 0, -0.6}), Way::free_bodies));
}

TEST(MasslessMotion, WhatClosesTheTreeDoesNotHoldTheSpin) {
  EXPECT_TRUE(massless_motion(spherical_rod_with_its_spin_held(), Way::mobilizers));
}

/// Mass moves if the pin is offset from the rod's axis or inclined to it.
TEST(MasslessMotion, APinAlongTheRodLeavesItsSpin) {
  EXPECT_TRUE(massless_motion(rod_on_pin_about({0, 0, 1}, {0, 0, -0.6}), Way::mobilizers));
  EXPECT_FALSE(massless_motion(rod_on_pin_about({0, 0, 1}, {0.01, 0, -0.6}), Way::mobilizers));
  EXPECT_FALSE(massless_motion(rod_on_pin_about({0, 0.01, 1}, {0, 0, -0.6}), Way::mobilizers));
}

TEST(MasslessMotion, ABodyOutboardOfARodResistsItsSpin) {
  scenes::Scene scene = rod();
  hold(scene, JointType::spherical, {}, at({0, 0, -0.6}));
  scenes::Body& block = scene.bodies.emplace_back();
  block.name = "block";
  block.mass = 1;
  block.inertia = scenes::Vector3{0.1, 0.2, 0.25};
  block.position = global({0, 0, 1.2});
  for (const bool spins : {false, true}) {
    scenes::Constraint& c = hold(scene, spins ? JointType::spherical : JointType::universal, at({0, 0, 0}),
                                 hinge({0, 0, 0.6}, {0, 1, 0}, {1, 0, 0}));
    c.i.body = 1;
    c.i.axis = global({1, 0, 0});
    EXPECT_EQ(massless_motion(scene, Way::mobilizers).has_value(), spins);
    scene.constraints.pop_back();
  }
}

/// Two collinear rods with a hinge between them can only spin together.
TEST(MasslessMotion, RodsInLineSpinTogether) {
  scenes::Scene scene = rod();
  scenes::Body& second = scene.bodies.emplace_back(scene.bodies[0]);
  second.name = "second";
  second.position = global({0, 0, 1.8});
  scenes::Constraint& c = hold(scene, JointType::revolute, hinge({0, 0, -0.6}, {0, 1, 0}, {1, 0, 0}),
                               hinge({0, 0, 0.6}, {0, 1, 0}, {1, 0, 0}));
  c.i.body = 1;
  hold(scene, JointType::spherical, {}, at({0, 0, -0.6}));
  EXPECT_TRUE(massless_motion(scene, Way::mobilizers));
  scene.constraints.pop_back();
  hold(scene, JointType::revolute, hinge({0, 0, 0}, global({1, 0, 0}), global({0, 1, 0})),
       hinge({0, 0, -0.6}, {1, 0, 0}, {0, 1, 0}));
  EXPECT_FALSE(massless_motion(scene, Way::mobilizers));
}

TEST(MasslessMotion, LengthsAreMeasuredInBodySizes) {
  for (const double unit : {1e-9, 1e9}) {
    scenes::Scene scene = rod_on_pin_about({0, 0, 1}, {0.01 * unit, 0, -0.6 * unit});
    scene.bodies[0].inertia = scenes::Vector3{0.3 * unit * unit, 0.3 * unit * unit, 0};
    EXPECT_FALSE(massless_motion(scene, Way::mobilizers));
    for (scenes::Side* side : {&scene.constraints[0].i, &scene.constraints[0].j})
      side->point = scenes::Vector3{0, 0, -0.6 * unit};
    EXPECT_TRUE(massless_motion(scene, Way::mobilizers));
  }
}

/// Without the check, Simbody would return meaningless accelerations.
TEST(MasslessMotion, ComparesTheTwinAndSaysWhy) {
  const scenes::Scene scene = spherical_rod_with_its_spin_held();
  for (const SimbodyComparison& c : compare_with_simbody({scene.name, scene, 0.0})) {
    SCOPED_TRACE(name_of(c.way));
    EXPECT_TRUE(c.twin);
    EXPECT_NE(c.refusal.find("has no inertia about an axis"), std::string::npos) << c.refusal;
    EXPECT_TRUE(c.agrees());
  }
}

TEST(MasslessMotion, TheSceneItselfIsComparedWhereMobilizersHoldIt) {
  for (const SimbodyComparison& c :
       compare_with_simbody({"rod", rod_on_pin_about({0, 1, 0}, {0, 0, -0.6}), 0.0})) {
    EXPECT_EQ(c.twin, c.way != Way::mobilizers);
    EXPECT_TRUE(c.agrees()) << name_of(c.way);
  }
}

}  // namespace
}  // namespace trivium
