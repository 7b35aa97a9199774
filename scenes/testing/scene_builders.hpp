#pragma once
/// Short functions that build scenes in C++. For tests only.

#include <optional>
#include <string>
#include <utility>

#include "scenes/scene.hpp"

namespace trivium::test {

inline scenes::Body body(std::string name, double mass, scenes::Vector3 inertia = {1, 1, 1},
                         scenes::Vector3 position = {}) {
  scenes::Body b;
  b.name = std::move(name);
  b.mass = mass;
  b.inertia = inertia;
  b.position = position;
  return b;
}

inline scenes::Side side(int body, std::optional<scenes::Vector3> point = {},
                         std::optional<scenes::Vector3> axis = {}, std::optional<scenes::Vector3> x = {}) {
  return {body, point, {}, axis, x};
}
/// A side of a dp1 or dp2, which has a vector instead of an axis.
inline scenes::Side vector_side(int body, const scenes::Vector3& vector) {
  return {body, {}, vector, {}, {}};
}

inline scenes::Constraint joint(ConstraintType type, std::string name, scenes::Side i, scenes::Side j) {
  scenes::Constraint c;
  c.type = type;
  c.name = std::move(name);
  c.i = std::move(i);
  c.j = std::move(j);
  return c;
}

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

inline scenes::Effect gravity(double g = 9.81) { return Gravity<double>{"", {0, 0, -g}}; }

}  // namespace trivium::test
