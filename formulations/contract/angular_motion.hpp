#pragma once
/// The angular motion of a body at a state, and its angular acceleration as a linear function of the reduced
/// unknowns x of a formulation. Point joints need
/// nothing else from the coordinates.

#include "bodies/numbers/register_vectors.hpp"

namespace trivium {

/// Rotation A, angular velocity omega [rad/s] and angular acceleration omega' = axes x + drift [rad/s^2], all
/// in the global frame; axes_T is the transpose of `axes` [3x3]. A body vector a has the rate a' =
/// cross(omega, a) and the second derivative a'' = cross(omega', a) + cross(omega, a'). A moment in the
/// global frame acts on x with the generalized force axes^T times the moment.
template <class S>
struct AngularMotion {
  PaddedColumns<S, 3> A, axes_T;
  Padded<S> omega, drift;

  AngularMotion() = default;
  AngularMotion(const Matrix3<S>& rotation, const Matrix3<S>& axes, const Vector3<S>& global_omega,
                const Vector3<S>& global_drift)
      : A(padded_columns<S>(rotation)),
        axes_T(transposed<S>(padded_columns<S>(axes))),
        omega(padded<S>(global_omega)),
        drift(padded<S>(global_drift)) {}
};

}  // namespace trivium
