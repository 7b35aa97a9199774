#pragma once
/// The types of constraint that a scene may name: the four basic ones, and the joints that are made of them.
/// What can be said of a type alone is said here; the rows of each type are in joint.hpp.

namespace trivium {

enum class ConstraintType {
  dp1,
  dp2,
  d,
  cd,
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

/// One basic constraint, with vectors and f(t) of its own.
constexpr bool is_basic(ConstraintType type) {
  switch (type) {  // whole, so that a new type must say it
    case ConstraintType::dp1:
    case ConstraintType::dp2:
    case ConstraintType::d:
    case ConstraintType::cd:
      return true;
    case ConstraintType::spherical:
    case ConstraintType::universal:
    case ConstraintType::revolute:
    case ConstraintType::cylindrical:
    case ConstraintType::translational:
    case ConstraintType::fixed:
    case ConstraintType::planar:
    case ConstraintType::in_line:
    case ConstraintType::in_plane:
    case ConstraintType::distance:
    case ConstraintType::rotation_driver:
      return false;
  }
  return false;
}

/// Its rows hold a point of j at a point of i: all three coordinates.
constexpr bool holds_a_point(ConstraintType type) {
  return type == ConstraintType::spherical || type == ConstraintType::universal ||
         type == ConstraintType::revolute || type == ConstraintType::fixed;
}

/// Its rows keep z_i and z_j parallel; parallel and antiparallel are two branches of the same rows.
constexpr bool has_parallel_axes(ConstraintType type) {
  return type == ConstraintType::revolute || type == ConstraintType::cylindrical ||
         type == ConstraintType::translational || type == ConstraintType::fixed ||
         type == ConstraintType::planar;
}

/// Its rows allow no relative rotation.
constexpr bool allows_no_rotation(ConstraintType type) {
  return type == ConstraintType::translational || type == ConstraintType::fixed;
}

/// It leaves one angle free, theta from u_i to u_j about z_i, which a torsional spring can measure.
constexpr bool has_an_angle(ConstraintType type) {
  return type == ConstraintType::revolute || type == ConstraintType::cylindrical;
}

}  // namespace trivium
