#pragma once
/// Euler angles of any body-fixed sequence: the rotation matrix of three angles,
///
///     A = R_s1(a) R_s2(b) R_s3(c),
///
/// and the angles of a rotation matrix. Haug (1989), section 9.3. At a singular A only the sum or difference
/// of the first and third angle is determined.

#include <cmath>

#include "bodies/rotations/euler_sequence.hpp"
#include "bodies/rotations/so3.hpp"

namespace trivium {

/// A = R_s1(a) R_s2(b) R_s3(c) [3x3], body to global; angles (a, b, c) [rad].
template <class Scalar>
Matrix3<Scalar> euler_rotation(const EulerSequence& s, const Vector3<Scalar>& angles) {
  return axis_rotation(s.axis[0], angles[0]) * axis_rotation(s.axis[1], angles[1]) *
         axis_rotation(s.axis[2], angles[2]);
}

/// The angles (a, b, c) [rad] of the rotation matrix A in the sequence s. The middle angle b lies in [0, pi]
/// for symmetric sequences (iji) and in [-pi/2, pi/2] for the others (ijk). At a singular A the angle a is
/// arbitrary, and c is such that the angles reproduce A.
template <class Scalar>
Vector3<Scalar> euler_angles(const EulerSequence& s, const Matrix3<Scalar>& A) {
  using std::atan2, std::hypot, std::sqrt;
  const auto [i, j, k3] = s.axis;
  const int k = 3 - i - j;                                          // the axis that is neither i nor j
  const Scalar sign = (j == (i + 1) % 3) ? Scalar(1) : Scalar(-1);  // +1 where (i, j, k) is right-handed
  const auto norm2 = [](const Scalar& x, const Scalar& y) { return Scalar(sqrt(x * x + y * y)); };
  Vector3<Scalar> angles;
  if (s.is_symmetric()) {
    const Scalar sin_b = norm2(A(i, j), A(i, k));
    angles[1] = atan2(sin_b, A(i, i));
    angles[0] = atan2(A(j, i), Scalar(-sign * A(k, i)));
  } else {
    const Scalar cos_b = norm2(A(i, i), A(i, j));
    angles[1] = atan2(Scalar(sign * A(i, k3)), cos_b);
    angles[0] = atan2(Scalar(-sign * A(j, k3)), A(k, k3));
  }
  // R_s3(c) = (R_s1(a) R_s2(b))^T A: gives c at every A, also at a singular one
  const Matrix3<Scalar> R3 = (axis_rotation(i, angles[0]) * axis_rotation(j, angles[1])).transpose() * A;
  const int m = (k3 + 1) % 3, n = (k3 + 2) % 3;
  angles[2] = atan2(R3(n, m), R3(m, m));
  return angles;
}

/// The same angles, with full turns added to the first and the third such that they are as near as possible
/// to those of `near`. Along a motion they then have no jumps.
template <class Scalar>
Vector3<Scalar> euler_angles_near(const Vector3<Scalar>& near, const EulerSequence& s,
                                  const Matrix3<Scalar>& A) {
  using std::atan, std::round;
  Vector3<Scalar> angles = euler_angles(s, A);
  const Scalar two_pi = 8 * atan(Scalar(1));
  for (const int k : {0, 2}) angles[k] += two_pi * round((near[k] - angles[k]) / two_pi);
  return angles;
}

}  // namespace trivium
