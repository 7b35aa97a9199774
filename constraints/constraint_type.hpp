#pragma once
/// The types of constraint that a scene may name: a basic one, or a joint that is made of basic ones. What
/// can be said of a joint's type alone is said here; the rows of each are in joint.hpp.

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

/// Its rows hold a point of j at a point of i: all three coordinates.
constexpr bool holds_a_point(ConstraintType type) {
  return type == JointType::spherical || type == JointType::universal || type == JointType::revolute ||
         type == JointType::fixed;
}

/// Its rows keep z_i and z_j parallel; parallel and antiparallel are two branches of the same rows.
constexpr bool has_parallel_axes(ConstraintType type) {
  return type == JointType::revolute || type == JointType::cylindrical || type == JointType::translational ||
         type == JointType::fixed || type == JointType::planar;
}

/// Its rows allow no relative rotation.
constexpr bool allows_no_rotation(ConstraintType type) {
  return type == JointType::translational || type == JointType::fixed;
}

/// It leaves one angle free, theta from u_i to u_j about z_i, which a torsional spring can measure.
constexpr bool has_an_angle(ConstraintType type) {
  return type == JointType::revolute || type == JointType::cylindrical;
}

}  // namespace trivium
