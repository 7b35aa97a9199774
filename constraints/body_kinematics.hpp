#pragma once
/// The interface between constraints and the coordinates of a formulation: the derivatives of a body vector
///
///     a = A a_bar,   a' = rate,   a'' = B q'' + bias,
///
/// where q'' is the rotational unknown of the body (omega_bar' in r-omega, p'' in r-p, epsilon'' in
/// r-epsilon). The equations of a constraint need nothing else of a formulation. Only the bounds that
/// features give for estimates of rounding errors (magnitude() in feature.hpp) also read the body's
/// omega_bar.

#include <concepts>

#include "bodies/numbers/vectors.hpp"

namespace trivium {

/// A body vector and its derivatives in the coordinates of one formulation.
template <class Scalar>
struct BodyVector {
  /// a_bar has body components; a, its rate a' and its bias (a'' at q'' = 0) have global components.
  Vector3<Scalar> a_bar, a, rate, bias;
};

/// The kinematics of one body in the coordinates of a formulation, as constraints see it.
template <class K>
concept BodyKinematics = requires(const K& body, const Vector3<typename K::Scalar>& v,
                                  const BodyVector<typename K::Scalar>& a) {
  { K::rotational_unknowns } -> std::convertible_to<int>;
  { body.r } -> std::convertible_to<Vector3<typename K::Scalar>>;      // centre of mass [m, global]
  { body.r_dot } -> std::convertible_to<Vector3<typename K::Scalar>>;  // its velocity [m/s, global]
  { body.A } -> std::convertible_to<Matrix3<typename K::Scalar>>;      // rotation matrix, body to global
  { body.vector(v) } -> std::convertible_to<BodyVector<typename K::Scalar>>;
  // B [3 x n], the derivative of a by the rotational coordinates (in r-omega by a small rotation), and v^T B
  // [1 x n]; n = rotational_unknowns
  { body.jacobian(a) } -> std::convertible_to<Matrix<typename K::Scalar, 3, K::rotational_unknowns>>;
  { body.jacobian_along(a, v) } -> std::convertible_to<Matrix<typename K::Scalar, 1, K::rotational_unknowns>>;
};

/// Which of the two bodies of a constraint.
enum class End { i, j };

/// Second derivatives of the coordinates of one body.
template <class Scalar, int RotationalUnknowns>
struct BodyAcceleration {
  Vector3<Scalar> r_ddot = Vector3<Scalar>::Zero();  ///< acceleration of the centre of mass [m/s^2, global]
  /// The rotational unknown q'' of the formulation.
  Vector<Scalar, RotationalUnknowns> q_ddot = Vector<Scalar, RotationalUnknowns>::Zero();
};

}  // namespace trivium
