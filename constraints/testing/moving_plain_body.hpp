#pragma once
/// Bodies of type PlainBody on smooth paths, to test constraints without any formulation. Used by tests only.
/// The path is given by its derivatives up to second order at one instant.

#include "bodies/rotations/so3.hpp"
#include "constraints/plain_body.hpp"
#include "constraints/testing/row_laws.hpp"

namespace trivium::test {

template <class S>
using MovingPlainBody = MovingBody<PlainBody<S>, PlainBody<Taylor<S>>>;

/// A body with the given r, A, velocity (r', omega) and acceleration (r'', omega') [global].
template <class S>
MovingPlainBody<S> moving_plain_body(const Vector3<S>& r, const Matrix3<S>& A,
                                     const typename MovingPlainBody<S>::Motion& velocity,
                                     const typename MovingPlainBody<S>::Motion& acceleration) {
  const Matrix3<S> W = tilde(velocity.q_ddot), W_dot = tilde(acceleration.q_ddot);
  const Vector3<S> zero = Vector3<S>::Zero();
  const Matrix3<S> A_dot = W * A, A_ddot = (W * W + W_dot) * A;
  return {{r, velocity.r_ddot, A, velocity.q_ddot},
          {taylor<S, 3, 1>(r, velocity.r_ddot, acceleration.r_ddot),
           taylor<S, 3, 1>(velocity.r_ddot, acceleration.r_ddot, zero), taylor<S, 3, 3>(A, A_dot, A_ddot),
           taylor<S, 3, 1>(velocity.q_ddot, acceleration.q_ddot, zero)},
          velocity,
          acceleration};
}

template <class S>
MovingPlainBody<S> random_plain_body(Random& random) {
  const Vector3<S> r = random.vector<S, 3>();
  const Matrix3<S> A = rotation_matrix(random.euler_parameters<S>());
  const typename MovingPlainBody<S>::Motion velocity{random.vector<S, 3>(), random.vector<S, 3>()};
  return moving_plain_body<S>(r, A, velocity, {random.vector<S, 3>(), random.vector<S, 3>()});
}

}  // namespace trivium::test
