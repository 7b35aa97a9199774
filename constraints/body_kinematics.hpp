#pragma once
/// All that constraints ask of the coordinates of a formulation: how a body vector a = A abar moves in them.
/// Its first derivative is `rate`; its second is jacobian q'' + bias, q the rotational unknowns of the body.

#include <concepts>

#include "bodies/numbers/vectors.hpp"

namespace trivium {

/// A body vector a = A abar as it moves in the coordinates of one formulation, with its rate and its bias
/// (the second derivative where the unknowns are zero).
template <class Scalar>
struct BodyVector {
  Vector3<Scalar> a_bar, a, rate, bias;
};

/// How body vectors move: all that the constraint library asks of coordinates.
template <class K>
concept BodyKinematics = requires(const K& body, const Vector3<typename K::Scalar>& v,
                                  const BodyVector<typename K::Scalar>& a) {
  { K::rotational_unknowns } -> std::convertible_to<int>;
  { body.r } -> std::convertible_to<Vector3<typename K::Scalar>>;      // centre of mass, global
  { body.r_dot } -> std::convertible_to<Vector3<typename K::Scalar>>;  // its velocity
  { body.A } -> std::convertible_to<Matrix3<typename K::Scalar>>;      // rotation, body to global
  { body.vector(v) } -> std::convertible_to<BodyVector<typename K::Scalar>>;
  { body.jacobian(a) } -> std::convertible_to<Matrix<typename K::Scalar, 3, K::rotational_unknowns>>;
  // v^T times it
  { body.jacobian_along(a, v) } -> std::convertible_to<Matrix<typename K::Scalar, 1, K::rotational_unknowns>>;
};

enum class End { i, j };

/// Second derivatives of one body's coordinates.
template <class Scalar, int RotationalUnknowns>
struct BodyAcceleration {
  Vector3<Scalar> r_ddot = Vector3<Scalar>::Zero();
  Vector<Scalar, RotationalUnknowns> q_ddot = Vector<Scalar, RotationalUnknowns>::Zero();
};

}  // namespace trivium
