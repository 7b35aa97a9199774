#pragma once
/// A two-link arm whose reach is known, for tests of drivers. For tests only.

#include <cmath>

#include "scenes/testing/scene_builders.hpp"

namespace trivium::test {

/// Two links of length 1 in the plane z = 0, the second turned by `bend` [rad] against the first. The last
/// constraint, "drive", is the row d . d of the two ends of the arm, which is at most 4.
inline scenes::Scene two_link_arm(double bend) {
  const scenes::Vector3 z{0, 0, 1}, back{-0.5, 0, 0}, front{0.5, 0, 0};
  scenes::Scene scene;
  scene.bodies = {body("a", 1, {0.02, 0.03, 0.025}, {0.5, 0, 0}),
                  body("b", 1, {0.02, 0.03, 0.025}, {1 + 0.5 * std::cos(bend), 0.5 * std::sin(bend), 0})};
  scene.bodies[1].orientation = scenes::AxisAngle{z, bend};
  scene.constraints = {
      joint(JointType::revolute, "A", side(scenes::ground, scenes::Vector3{}, z), side(0, back, z)),
      joint(JointType::revolute, "B", side(0, front, z), side(1, back, z)),
      joint(basic_type<D>, "drive", side(scenes::ground, scenes::Vector3{}), side(1, front))};
  return scene;
}

}  // namespace trivium::test
