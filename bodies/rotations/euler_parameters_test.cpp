/// The matrices E and G, and the relations between rates of Euler parameters and angular velocity.

#include "bodies/numbers/scalar.hpp"
#include "bodies/rotations/so3.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/scalars.hpp"

namespace trivium {
namespace {

using test::distance, test::draw_euler_parameters, test::draw_vector, test::for_all, test::roundings;

template <class S>
class EulerParameters : public testing::Test {};
TYPED_TEST_SUITE(EulerParameters, test::TestedScalars);

TYPED_TEST(EulerParameters, EAndGHaveOrthonormalRowsAndAnnihilateP) {
  using S = TypeParam;
  for_all([] {
    const Vector4<S> p = draw_euler_parameters<S>();
    const Matrix<S, 3, 4> G = G_matrix(p), E = E_matrix(p);
    const Matrix<S, 4, 4> complement = Matrix<S, 4, 4>::Identity() - p * p.transpose();
    for (const Matrix<S, 3, 4>& half : {G, E}) {
      RC_ASSERT(distance(half * half.transpose(), Matrix3<S>::Identity()) <= roundings<S>(16));
      RC_ASSERT(distance(half.transpose() * half, complement) <= roundings<S>(16));
      RC_ASSERT(distance(half * p, Vector3<S>::Zero()) <= roundings<S>(8));
    }
  });
}

TYPED_TEST(EulerParameters, AngularVelocityIsTwiceGPDot) {
  using S = TypeParam;
  for_all([] {
    const Vector4<S> p = draw_euler_parameters<S>();
    const Vector3<S> omega_bar = draw_vector<S, 3>(4);
    const Vector4<S> p_dot = G_matrix(p).transpose() * omega_bar / 2;
    RC_ASSERT(distance(2 * G_matrix(p) * p_dot, omega_bar) <= roundings<S>(100));
    RC_ASSERT(distance(-2 * G_matrix(p_dot) * p, omega_bar) <= roundings<S>(100));
    // A' = A tilde(omega_bar), with A' from the product rule on A = E G^T
    const Matrix3<S> A_dot =
        E_matrix(p_dot) * G_matrix(p).transpose() + E_matrix(p) * G_matrix(p_dot).transpose();
    RC_ASSERT(distance(A_dot, rotation_matrix(p) * tilde(omega_bar)) <= roundings<S>(100));
  });
}

TYPED_TEST(EulerParameters, AngularAccelerationIsTwiceGPDdot) {
  using S = TypeParam;
  for_all([] {
    const Vector4<S> p = draw_euler_parameters<S>();
    const Vector3<S> omega_bar = draw_vector<S, 3>(4), omega_bar_dot = draw_vector<S, 3>(4);
    const Vector4<S> p_dot = G_matrix(p).transpose() * omega_bar / 2;
    // p'' of a path with |p| = 1; A'' from the product rule gives omega_bar' independently
    const Vector4<S> p_ddot = G_matrix(p).transpose() * omega_bar_dot / 2 - omega_bar.squaredNorm() / 4 * p;
    RC_ASSERT(distance(2 * G_matrix(p) * p_ddot, omega_bar_dot) <= roundings<S>(300));
    const Matrix3<S> A = rotation_matrix(p);
    const Matrix3<S> A_ddot = E_matrix(p_ddot) * G_matrix(p).transpose() +
                              2 * E_matrix(p_dot) * G_matrix(p_dot).transpose() +
                              E_matrix(p) * G_matrix(p_ddot).transpose();
    const Matrix3<S> expected = A * (tilde(omega_bar) * tilde(omega_bar) + tilde(omega_bar_dot));
    RC_ASSERT(distance(A_ddot, expected) <= roundings<S>(2000));
  });
}

}  // namespace
}  // namespace trivium
