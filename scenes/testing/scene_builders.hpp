#pragma once
/// Scenes of tests. For tests only.

#include "scenes/building.hpp"

namespace trivium::test {

using building::body, building::gravity, building::joint, building::side, building::vector_side;

/// One body, number 0, that turns about its z axis on a revolute to the ground, against a torsional spring
/// with a damper.
inline scenes::Scene sprung_wheel(double inertia, double speed, double stiffness, double damping) {
  scenes::Scene scene;
  scene.name = "sprung wheel";
  scene.bodies.push_back(body("wheel", 1, {inertia, inertia, inertia}));
  scene.bodies[0].angular_velocity = {0, 0, speed};
  scene.constraints.push_back(joint(JointType::revolute, "axle",
                                    side(scenes::ground, {}, {{0, 0, 1}}, {{1, 0, 0}}),
                                    side(0, {}, {{0, 0, 1}}, {{1, 0, 0}})));
  TorsionalSpringDamper<double> spring;
  spring.angle.joint = 0;
  spring.stiffness = stiffness;
  spring.damping = damping;
  scene.effects.emplace_back(spring);
  return scene;
}

}  // namespace trivium::test
