/// Laws of the Formulation concept, tested in every formulation: accelerations.

#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "formulations/testing/body_samples.hpp"

namespace trivium {
namespace {

using test::distance, test::for_all_samples, test::Random, test::roundings;

template <class F>
class FormulationAccelerations : public testing::Test {};
TYPED_TEST_SUITE(FormulationAccelerations, test::TestedFormulations, test::FormulationNames);

TYPED_TEST(FormulationAccelerations, AngularAccelerationGoesThereAndBack) {
  using F = TypeParam;
  using S = typename F::Scalar;
  for_all_samples<F>([](const auto& s) {
    const typename F::Unknown q_ddot = test::unknown_of<F>(s.body, s.omega_bar_dot);
    EXPECT_LE(distance(F::to_angular_acceleration(s.body, q_ddot), s.omega_bar_dot), roundings<S>(1000));
    // q'' is an affine function of omega_bar' with the matrix lift, and satisfies the internal row
    const typename F::Unknown at_zero = test::unknown_of<F>(s.body, Vector3<S>::Zero());
    EXPECT_LE(distance(q_ddot - at_zero, F::lift(s.body) * s.omega_bar_dot), roundings<S>(1000));
    EXPECT_LE(distance(F::internal_jacobian(s.body) * q_ddot, F::internal_gamma(s.body)), roundings<S>(1000));
  });
}

TYPED_TEST(FormulationAccelerations, AngularAccelerationIsTheDerivativeOfAngularVelocity) {
  using F = TypeParam;
  using S = typename F::Scalar;
  Random random(52);
  test::for_all_charts([&](const ChartOptions& options) {
    auto path = test::random_path<F>(random, options);
    if constexpr (F::internal_constraints == 1) {  // 2 G p' is an angular velocity only for unit p
      path.q_dot -= path.p.dot(path.q_dot) * path.p;
      path.q_ddot -= (path.p.dot(path.q_ddot) + path.q_dot.squaredNorm()) * path.p;
    }
    const auto body = test::moving_body(path);
    EXPECT_LE(distance(test::first_derivative<S, 3, 1>(body.along.omega_bar),
                       F::to_angular_acceleration(body.now, body.acceleration.q_ddot)),
              roundings<S>(1000));
  });
}

}  // namespace
}  // namespace trivium
