#pragma once
/// The types of constraints in a scene: a basic constraint, or a joint that consists of basic constraints.
/// `properties_of` gives the properties that depend on the type alone; joint.hpp has the rows of each joint.
/// Switches over JointType have no default case, so that a new type does not compile until all have its case.

namespace trivium {

/// The joints; joint.hpp (JointBuilder) states the rows and the free motions of each.
enum class JointType {
  basic,  ///< one basic constraint, not a joint
  spherical,
  universal,
  revolute,
  cylindrical,
  translational,
  fixed,
  planar,
  in_line,
  in_plane,
  distance,
  rotation_driver
};

/// The type of a joint, or of a basic constraint by its index in the list (basic_constraint.hpp: basic_type).
struct ConstraintType {
  JointType joint = JointType::basic;
  int place = 0;  ///< index of a basic constraint in its list; 0 for joints

  constexpr ConstraintType(JointType type) : joint(type) {}  // NOLINT: implicit, for joints
  constexpr ConstraintType(JointType type, int place_in_list) : joint(type), place(place_in_list) {}
  constexpr bool is_basic() const { return joint == JointType::basic; }
  bool operator==(const ConstraintType&) const = default;
};

/// Properties that follow from the type of a joint alone.
struct JointProperties {
  /// A point of j coincides with a point of i: three rows.
  bool holds_a_point = false;
  /// z_i and z_j are parallel. The rows also hold if z_i = -z_j, a second branch of solutions.
  bool has_parallel_axes = false;
  /// The rows allow no relative rotation.
  bool allows_no_rotation = false;
  /// The joint keeps the axis z, and the angle theta from u_i to u_j about z is free (revolute, cylindrical):
  /// a torsional spring can act on it.
  bool has_an_angle = false;
  /// The joint has a parameter `distance` [m].
  bool states_a_distance = false;
  /// The rows prescribe theta = alpha(t). They also hold for theta = alpha(t) + pi, a second branch.
  bool drives_an_angle = false;
};

/// The properties of a type; all false for basic constraints.
constexpr JointProperties properties_of(ConstraintType type) {
  switch (type.joint) {
    case JointType::spherical:
    case JointType::universal:
      return {.holds_a_point = true};
    case JointType::revolute:
      return {.holds_a_point = true, .has_parallel_axes = true, .has_an_angle = true};
    case JointType::cylindrical:
      return {.has_parallel_axes = true, .has_an_angle = true};
    case JointType::translational:
      return {.has_parallel_axes = true, .allows_no_rotation = true};
    case JointType::fixed:
      return {.holds_a_point = true, .has_parallel_axes = true, .allows_no_rotation = true};
    case JointType::planar:
      return {.has_parallel_axes = true};
    case JointType::basic:
    case JointType::in_line:
    case JointType::in_plane:
      return {};
    case JointType::distance:
      return {.states_a_distance = true};
    case JointType::rotation_driver:
      return {.drives_an_angle = true};
  }
  return {};
}

}  // namespace trivium
