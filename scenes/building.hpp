#pragma once
/// Short functions that build scenes in C++: bodies, the sides of joints, joints, gravity.

#include <optional>
#include <string>
#include <utility>

#include "scenes/scene.hpp"

namespace trivium::building {

/// A body at rest with its axes along those of the ground: mass [kg], moments of inertia [kg m^2], position
/// of the centre of mass [m].
inline scenes::Body body(std::string name, double mass, scenes::Vector3 inertia = {1, 1, 1},
                         scenes::Vector3 position = {}) {
  scenes::Body b;
  b.name = std::move(name);
  b.mass = mass;
  b.inertia = inertia;
  b.position = position;
  return b;
}

/// A side of a joint on a body, or on scenes::ground: point [m], axis and x axis in the body frame.
inline scenes::Side side(int body, std::optional<scenes::Vector3> point = {},
                         std::optional<scenes::Vector3> axis = {}, std::optional<scenes::Vector3> x = {}) {
  return {body, point, {}, axis, x};
}
/// A side of a dp1 or dp2, which has a vector instead of an axis.
inline scenes::Side vector_side(int body, const scenes::Vector3& vector) {
  return {body, {}, vector, {}, {}};
}

/// A joint or a basic constraint without parameters.
inline scenes::Constraint joint(ConstraintType type, std::string name, scenes::Side i, scenes::Side j) {
  scenes::Constraint c;
  c.type = type;
  c.name = std::move(name);
  c.i = std::move(i);
  c.j = std::move(j);
  return c;
}

/// Along -z [m/s^2].
inline scenes::Effect gravity(double g = 9.81) { return Gravity<double>{"", {0, 0, -g}}; }

}  // namespace trivium::building
