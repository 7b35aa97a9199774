#pragma once
/// Whether a body can have an inertia tensor: symmetric, positive semidefinite, and no principal moment above
/// the sum of the other two. Decided here: the tolerance, 1e-12 of the trace; scenes/format/scene_checks.hpp
/// has the same for files.

#include <Eigen/Core>

namespace trivium {

/// Principal moments [kg m^2, ascending] and what they violate beyond 1e-12 of the trace.
struct InertiaCheck {
  Eigen::Vector3d principal_moments;
  bool symmetric = true;
  bool positive_semidefinite = true;
  bool triangle_inequality = true;  ///< no principal moment exceeds the sum of the other two

  bool physical() const { return symmetric && positive_semidefinite && triangle_inequality; }
};

InertiaCheck check_inertia(const Eigen::Matrix3d& inertia);

}  // namespace trivium
