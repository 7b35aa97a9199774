#pragma once
/// Scenes with one body under gravity, which may be held by constraints. For the Simbody tests only.

#include <string>

#include "scenes/scene.hpp"

namespace trivium::one_body {

inline constexpr double g = 9.81, m = 2.5;

/// One body at the origin, at rest, under gravity along -z.
inline scenes::Scene scene_at_rest() {
  scenes::Scene scene;
  scene.name = "one_body";
  scenes::Body& body = scene.bodies.emplace_back();
  body.name = "body";
  body.mass = m;
  body.inertia = scenes::Vector3{0.3, 0.4, 0.5};
  scene.effects.push_back(Gravity<double>{"", {0, 0, -g}});
  return scene;
}

inline scenes::Side at(const scenes::Vector3& point) {
  scenes::Side side;
  side.point = point;
  return side;
}
inline scenes::Side along(const scenes::Vector3& vector) {
  scenes::Side side;
  side.vector = vector;
  return side;
}
inline scenes::Side hinge(const scenes::Vector3& point, const scenes::Vector3& axis,
                          const scenes::Vector3& x) {
  scenes::Side side = at(point);
  side.axis = axis;
  side.x = x;
  return side;
}
inline const scenes::Side upright = hinge({0, 0, 0}, {0, 0, 1}, {1, 0, 0});

/// Adds a constraint between the ground (body i) and the body (body j).
inline scenes::Constraint& hold(scenes::Scene& scene, ConstraintType type, const scenes::Side& on_ground,
                                scenes::Side on_body) {
  on_body.body = 0;
  scenes::Constraint& c = scene.constraints.emplace_back();
  c.type = type;
  c.name = std::to_string(scene.constraints.size());
  c.i = on_ground;
  c.j = on_body;
  return c;
}

inline Torque<double> torque(double x, double y, double z) { return {"", 0, {x, y, z}}; }

}  // namespace trivium::one_body
