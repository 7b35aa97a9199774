/// Laws of the Formulation concept, tested in every formulation: poses and velocities.

#include "bodies/numbers/quad.hpp"
#include "bodies/rotations/so3.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "formulations/testing/body_samples.hpp"

namespace trivium {
namespace {

using test::distance, test::for_all_samples, test::roundings;

template <class F>
class FormulationKinematics : public testing::Test {};
TYPED_TEST_SUITE(FormulationKinematics, test::TestedFormulations, test::FormulationNames);

TYPED_TEST(FormulationKinematics, KeepsPoseAndAngularVelocity) {
  using F = TypeParam;
  using S = typename F::Scalar;
  for_all_samples<F>([](const auto& s) {
    const Vector4<S> back = F::to_euler_parameters(s.chart, s.q);
    EXPECT_LE(std::min(distance(back, s.p), distance(back, -s.p)), roundings<S>(40));
    EXPECT_LE(distance(s.body.A, rotation_matrix(s.p)), roundings<S>(40));
    EXPECT_LE(distance(s.body.omega_bar, s.omega_bar), roundings<S>(100));
  });
}

TYPED_TEST(FormulationKinematics, BodyVectorJacobianIsTheDerivativeAlongTheRetraction) {
  using F = TypeParam;
  using S = typename F::Scalar;
  if constexpr (std::same_as<S, Quad>)
    for_all_samples<F>([](const auto& s) {
      const S h(1e-11);
      const Vector3<S> none = Vector3<S>::Zero();
      const typename F::Orientation from = F::orientation_of(s.chart, s.p);
      const typename F::Unknown v = F::velocity_of(s.chart, s.q);
      for (int k = 0; k < 3; ++k) {
        // the increment of the unknowns that rotates the body about its axis k
        const typename F::Unknown step = F::lift(s.body) * Vector3<S>::Unit(k);
        const auto moved = [&](const S& by) {
          const auto orientation = F::retract(s.chart, from, (by * step).eval());
          return Matrix3<S>(
              F::kinematics(s.chart, none, none, F::from_orientation(s.chart, orientation, v)).A);
        };
        const Matrix3<S> A_k = (moved(h) - moved(-h)) / (2 * h);
        EXPECT_LE(distance(A_k * s.a_bar, s.body.jacobian(s.body.vector(s.a_bar)) * step), 1e-19);
        EXPECT_LE(distance(A_k, s.body.A * tilde<S>(Vector3<S>::Unit(k))), 1e-19);
      }
    });
  else  // the retraction of a zero increment is the starting orientation
    for_all_samples<F>([](const auto& s) {
      const auto orientation = F::retract(s.chart, F::orientation_of(s.chart, s.p), F::Unknown::Zero());
      const auto q = F::from_orientation(s.chart, orientation, F::velocity_of(s.chart, s.q));
      const Vector4<S> p = F::to_euler_parameters(s.chart, q);
      EXPECT_LE(std::min(distance(p, s.p), distance(p, -s.p)), roundings<S>(40));
    });
}

TYPED_TEST(FormulationKinematics, BodyVectorRateAndBiasAreThoseOfARotatingVector) {
  using F = TypeParam;
  using S = typename F::Scalar;
  for_all_samples<F>([](const auto& s) {
    const Matrix3<S> A = rotation_matrix(s.p), W = tilde(s.omega_bar);
    EXPECT_LE(distance(s.body.vector(s.a_bar).rate, A * W * s.a_bar), roundings<S>(300));
    // with q'' for omega_bar' = 0 only the centripetal term of a'' remains
    const typename F::Unknown q_ddot = test::unknown_of<F>(s.body, Vector3<S>::Zero());
    EXPECT_LE(distance(s.body.jacobian(s.body.vector(s.a_bar)) * q_ddot + s.body.vector(s.a_bar).bias,
                       A * W * W * s.a_bar),
              roundings<S>(2000));
  });
}

TYPED_TEST(FormulationKinematics, JacobianTimesLiftIsTheBodyFrameJacobian) {
  using F = TypeParam;
  using S = typename F::Scalar;
  for_all_samples<F>([](const auto& s) {
    EXPECT_LE(distance(s.body.jacobian(s.body.vector(s.a_bar)) * F::lift(s.body),
                       -rotation_matrix(s.p) * tilde(s.a_bar)),
              roundings<S>(300));
  });
}

}  // namespace
}  // namespace trivium
