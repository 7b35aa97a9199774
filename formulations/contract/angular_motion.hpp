#pragma once
/// How a body turns in the reduced unknowns x of a formulation. All that a point joint asks of coordinates.

#include "bodies/numbers/register_vectors.hpp"

namespace trivium {

/// With omega' = axes x + drift in the global frame, a body vector a has the rate omega x a, the second
/// derivative (axes x + drift) x a + omega x (omega x a), and a moment about it does axes^T times itself.
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
