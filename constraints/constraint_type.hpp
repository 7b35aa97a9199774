#pragma once
/// The types of constraint that a scene may name: a basic one, or a joint that is made of basic ones. What
/// can be said of a joint's type alone is said here; the rows of each are in joint.hpp. Every switch over
/// them has a case for each: a new one does not compile before it has them all.

namespace trivium {

enum class JointType {
  basic,  ///< no joint: one basic constraint
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

/// A joint, or a basic constraint by its place in the list (basic_type<DP1>, in basic_constraint.hpp).
struct ConstraintType {
  JointType joint = JointType::basic;
  int place = 0;  ///< of a basic constraint

  constexpr ConstraintType(JointType type) : joint(type) {}  // NOLINT: a joint is a type of constraint
  constexpr ConstraintType(JointType type, int place_in_list) : joint(type), place(place_in_list) {}
  constexpr bool is_basic() const { return joint == JointType::basic; }
  bool operator==(const ConstraintType&) const = default;
};

/// What can be said of a joint's type alone.
struct JointProperties {
  /// Its rows hold a point of j at a point of i: all three coordinates.
  bool holds_a_point = false;
  /// Its rows keep z_i and z_j parallel; parallel and antiparallel are two branches of the same rows.
  bool has_parallel_axes = false;
  /// Its rows allow no relative rotation.
  bool allows_no_rotation = false;
  /// It leaves one angle free, theta from u_i to u_j about z_i, which a torsional spring can measure.
  bool has_an_angle = false;
  /// It states a length [m] of its own.
  bool states_a_distance = false;
  /// It drives the angle theta as alpha(t), and has a branch half a turn off.
  bool drives_an_angle = false;
};

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
