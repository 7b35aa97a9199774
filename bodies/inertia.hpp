#pragma once
/// Whether a body can have an inertia tensor: symmetric, positive semidefinite, and no principal moment above
/// the sum of the other two (the integrals of y^2 + z^2, z^2 + x^2 and x^2 + y^2 over the mass). Decided
/// here: the tolerance of all that is asked of a tensor, in files as well.

#include <Eigen/Core>

namespace trivium {

/// As a share of the trace: what rounding leaves of a principal moment that is none, and of an equation
/// between moments. A file's digits and a rotation of the axes leave 1e-15; a wire of 0.1 mm over 10 m has
/// 8e-11.
inline constexpr double inertia_tolerance = 1e-12;

/// Principal moments [kg m^2, ascending] and what they violate beyond inertia_tolerance.
struct InertiaCheck {
  Eigen::Vector3d principal_moments;
  bool symmetric = true;
  bool positive_semidefinite = true;
  bool triangle_inequality = true;  ///< no principal moment exceeds the sum of the other two

  bool physical() const { return symmetric && positive_semidefinite && triangle_inequality; }
};

InertiaCheck check_inertia(const Eigen::Matrix3d& inertia);

}  // namespace trivium
