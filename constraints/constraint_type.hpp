#pragma once
/// The constraints that a scene may name: the four basic ones, and the joints that are made of them.

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

}  // namespace trivium
