/// The laws of the Formulation concept, the same for all: places and velocities.

#include "bodies/numbers/quad.hpp"
#include "bodies/rotations/so3.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "formulations/testing/body_samples.hpp"

namespace trivium {
namespace {

using test::distance, test::for_all_samples, test::Random, test::roundings;

template <class F>
class FormulationLaws : public testing::Test {};
TYPED_TEST_SUITE(FormulationLaws, test::TestedFormulations, test::FormulationNames);

TYPED_TEST(FormulationLaws, KeepsPoseAndAngularVelocity) {
  using F = TypeParam;
  using S = typename F::Scalar;
  for_all_samples<F>([](const auto& s) {
    const Vector4<S> back = F::to_euler_parameters(s.chart, s.q);
    EXPECT_LE(std::min(distance(back, s.p), distance(back, -s.p)), roundings<S>(40));
    EXPECT_LE(distance(s.body.A, rotation_matrix(s.p)), roundings<S>(40));
    EXPECT_LE(distance(s.body.omega_bar, s.omega_bar), roundings<S>(100));
  });
}

TYPED_TEST(FormulationLaws, BodyVectorJacobianIsTheDerivativeAlongTheRetraction) {
  using F = TypeParam;
  using S = typename F::Scalar;
  if constexpr (std::same_as<S, Quad>)
    for_all_samples<F>([](const auto& s) {
      const S h(1e-11);
      const Vector3<S> none = Vector3<S>::Zero();
      const typename F::Orientation from = F::orientation_of(s.chart, s.p);
      const typename F::Unknown v = F::velocity_of(s.chart, s.q);
      for (int k = 0; k < 3; ++k) {
        // the increment that turns the body about its own axis k
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
  else  // the retraction of no increment is where it started
    for_all_samples<F>([](const auto& s) {
      const auto orientation = F::retract(s.chart, F::orientation_of(s.chart, s.p), F::Unknown::Zero());
      const auto q = F::from_orientation(s.chart, orientation, F::velocity_of(s.chart, s.q));
      const Vector4<S> p = F::to_euler_parameters(s.chart, q);
      EXPECT_LE(std::min(distance(p, s.p), distance(p, -s.p)), roundings<S>(40));
    });
}

TYPED_TEST(FormulationLaws, BodyVectorRateAndBiasAreThoseOfARotatingVector) {
  using F = TypeParam;
  using S = typename F::Scalar;
  for_all_samples<F>([](const auto& s) {
    const Matrix3<S> A = rotation_matrix(s.p), W = tilde(s.omega_bar);
    EXPECT_LE(distance(s.body.vector(s.a_bar).rate, A * W * s.a_bar), roundings<S>(300));
    // q'' of no angular acceleration leaves the centripetal term alone
    const typename F::Unknown q_ddot = test::unknown_of<F>(s.body, Vector3<S>::Zero());
    EXPECT_LE(distance(s.body.jacobian(s.body.vector(s.a_bar)) * q_ddot + s.body.vector(s.a_bar).bias,
                       A * W * W * s.a_bar),
              roundings<S>(2000));
  });
}

TYPED_TEST(FormulationLaws, JacobianTimesLiftIsTheBodyFrameJacobian) {
  using F = TypeParam;
  using S = typename F::Scalar;
  for_all_samples<F>([](const auto& s) {
    EXPECT_LE(distance(s.body.jacobian(s.body.vector(s.a_bar)) * F::lift(s.body),
                       -rotation_matrix(s.p) * tilde(s.a_bar)),
              roundings<S>(300));
  });
}

TYPED_TEST(FormulationLaws, DisplacementLeadsFromOnePlaceToTheOther) {
  using F = TypeParam;
  using S = typename F::Scalar;
  Random random(53);
  for_all_samples<F>([&](const auto& s) {
    const typename F::Orientation from = F::orientation_of(s.chart, s.p);
    const typename F::Unknown by = S(0.3) * random.vector<S, F::rotational_unknowns>();
    EXPECT_LE(distance(F::displacement(s.chart, from, F::step(s.chart, from, by)), by), roundings<S>(2000));
    EXPECT_LE(distance(F::displacement(s.chart, from, from), F::Unknown::Zero()), roundings<S>(2000));
  });
}

// where a body moves with a velocity, its displacement from where it was grows by displacement_rate
TYPED_TEST(FormulationLaws, DisplacementGrowsAsTheBodyMoves) {
  using F = TypeParam;
  using S = typename F::Scalar;
  if constexpr (std::same_as<S, Quad>) {
    Random random(54);
    for_all_samples<F>([&](const auto& s) {
      const typename F::Orientation from = F::orientation_of(s.chart, s.p);
      const typename F::Unknown by = S(0.2) * random.vector<S, F::rotational_unknowns>();
      typename F::Orientation at = F::step(s.chart, from, by);
      const typename F::Unknown v = F::velocity_of(s.chart, s.q);
      const S h(1e-11);
      const auto after = [&](const S& t) {
        return F::displacement(s.chart, from, F::step(s.chart, at, (t * v).eval()));
      };
      EXPECT_LE(distance((after(h) - after(-h)) / (2 * h), F::displacement_rate(by, v)), 1e-18);
    });
  }
}

TYPED_TEST(FormulationLaws, ConstrainMeetsTheInternalRowByItsShare) {
  using F = TypeParam;
  using S = typename F::Scalar;
  Random random(55);
  for_all_samples<F>([&](const auto& s) {
    const typename F::Orientation from = F::orientation_of(s.chart, s.p);
    const S share(0.01);
    typename F::Unknown x = random.vector<S, F::rotational_unknowns>(), before = x;
    typename F::Orientation at = F::step(s.chart, from, (share * x).eval());
    const typename F::Orientation off = at;
    F::normalise_step(at, share, x);
    EXPECT_LE(distance(F::step(s.chart, off, (share * (x - before)).eval()), at), roundings<S>(100));
    typename F::Unknown v = random.vector<S, F::rotational_unknowns>(), change = F::Unknown::Zero();
    F::normalise_step_velocity(at, v, share, change);
    v += share * change;
    if constexpr (F::internal_constraints > 0) {
      EXPECT_LE(std::abs(static_cast<double>(S(at.norm() - 1))), roundings<S>(10));
      EXPECT_LE(std::abs(static_cast<double>(S(at.dot(v)))), roundings<S>(10));
    } else {
      EXPECT_EQ(x, before);
      EXPECT_EQ(change, F::Unknown::Zero());
    }
  });
}

}  // namespace
}  // namespace trivium
