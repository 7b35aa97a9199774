#pragma once
/// Checks whether an inertia tensor is physically possible: symmetric, positive semidefinite, and no
/// principal moment greater than the sum of the other two. (The moments are the integrals of y^2 + z^2, z^2 +
/// x^2 and x^2 + y^2 over the mass.) The checks of scenes and of the mass metric use the tolerance that is
/// defined here.

#include <Eigen/Core>

namespace trivium {

/// Tolerance for moments of inertia, relative to the trace [-]: a smaller principal moment counts as zero.
/// The value is above the relative errors of 1e-15 that decimal digits and rotations of the axes leave, and
/// below 8e-11, the smallest principal moment of a wire 0.1 mm thick and 10 m long.
inline constexpr double inertia_tolerance = 1e-12;

/// Result of check_inertia; each flag is false if its condition is violated by more than inertia_tolerance.
struct InertiaCheck {
  Eigen::Vector3d principal_moments;  ///< eigenvalues of the symmetric part [kg m^2], ascending
  bool symmetric = true;
  bool positive_semidefinite = true;
  bool triangle_inequality = true;  ///< no principal moment exceeds the sum of the other two

  bool physical() const { return symmetric && positive_semidefinite && triangle_inequality; }
};

/// Checks a tensor [3x3, kg m^2] in any frame, about any point.
InertiaCheck check_inertia(const Eigen::Matrix3d& inertia);

}  // namespace trivium
