/// The laws of the Formulation concept, the same for all.

#include "formulations/moving_body.hpp"

namespace trivium {
namespace {

using test::distance, test::Random, test::roundings;

template <class F>
class FormulationLaws : public testing::Test {};
TYPED_TEST_SUITE(FormulationLaws, test::TestedFormulations, test::FormulationNames);

template <class F>
struct Sample {
  using S = typename F::Scalar;
  typename F::Chart chart;
  Vector4<S> p;
  Vector3<S> omega_bar, omega_bar_dot, a_bar;
  Matrix3<S> J_bar;
  typename F::Coordinates q;
  typename F::Kinematics body;
};

/// Poses and velocities at home in every formulation, over all sequences.
template <class F, class Law>
void for_all_samples(const Law& law) {
  using S = typename F::Scalar;
  Random random(51);
  for (const auto name : euler_sequence_names)
    for (int n = 0; n < 8; ++n) {
      Sample<F> s;
      s.p = random.euler_parameters<S>();
      s.chart = F::choose_chart({*parse_euler_sequence(name), true}, s.p);
      s.omega_bar = random.vector<S, 3>();
      s.omega_bar_dot = random.vector<S, 3>();
      s.a_bar = random.vector<S, 3>();
      const Matrix3<S> axes = rotation_matrix(random.euler_parameters<S>());
      s.J_bar = axes * Vector3<S>(S(1), S(random.uniform(1, 2)), S(2)).asDiagonal() * axes.transpose();
      s.q = F::from_pose(s.chart, s.p, s.omega_bar);
      const Vector3<S> r = random.vector<S, 3>(), r_dot = random.vector<S, 3>();
      s.body = F::kinematics(s.chart, r, r_dot, s.q);
      law(s);
    }
}

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
      for (int k = 0; k < 3; ++k) {
        // the increment that turns the body about its own axis k
        const typename F::Unknown step = F::lift(s.body) * Vector3<S>::Unit(k);
        const auto moved = [&](const S& by) {
          return Matrix3<S>(
              F::kinematics(s.chart, none, none, F::retract(s.chart, s.q, (by * step).eval())).A);
        };
        const Matrix3<S> A_k = (moved(h) - moved(-h)) / (2 * h);
        EXPECT_LE(distance(A_k * s.a_bar, s.body.jacobian(s.body.vector(s.a_bar)) * step), 1e-19);
        EXPECT_LE(distance(A_k, s.body.A * tilde<S>(Vector3<S>::Unit(k))), 1e-19);
      }
    });
  else  // the retraction of no increment is where it started
    for_all_samples<F>([](const auto& s) {
      const auto q = F::retract(s.chart, s.q, F::Unknown::Zero());
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
    const typename F::Unknown q_ddot = F::from_angular_acceleration(s.body, Vector3<S>::Zero());
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

TYPED_TEST(FormulationLaws, AngularAccelerationGoesThereAndBack) {
  using F = TypeParam;
  using S = typename F::Scalar;
  for_all_samples<F>([](const auto& s) {
    const typename F::Unknown q_ddot = F::from_angular_acceleration(s.body, s.omega_bar_dot);
    EXPECT_LE(distance(F::to_angular_acceleration(s.body, q_ddot), s.omega_bar_dot), roundings<S>(1000));
    // q'' is affine in omega_bar' with slope lift, and keeps the internal row
    const typename F::Unknown at_zero = F::from_angular_acceleration(s.body, Vector3<S>::Zero());
    EXPECT_LE(distance(q_ddot - at_zero, F::lift(s.body) * s.omega_bar_dot), roundings<S>(1000));
    EXPECT_LE(distance(F::internal_jacobian(s.body) * q_ddot, F::internal_gamma(s.body)), roundings<S>(1000));
  });
}

TYPED_TEST(FormulationLaws, AngularAccelerationIsTheDerivativeOfAngularVelocity) {
  using F = TypeParam;
  using S = typename F::Scalar;
  Random random(52);
  test::for_all_charts([&](const ChartOptions& options) {
    auto path = test::random_path<F>(random, options);
    if constexpr (F::internal_constraints == 1) {  // omega_bar is 2 G p' on the unit sphere only
      path.q_dot -= path.p.dot(path.q_dot) * path.p;
      path.q_ddot -= (path.p.dot(path.q_ddot) + path.q_dot.squaredNorm()) * path.p;
    }
    const auto body = test::moving_body(path);
    EXPECT_LE(distance(test::first_derivative<S, 3, 1>(body.along.omega_bar),
                       F::to_angular_acceleration(body.now, body.acceleration.q_ddot)),
              roundings<S>(1000));
  });
}

TYPED_TEST(FormulationLaws, EquationsAreEulersInDisguise) {
  using F = TypeParam;
  using S = typename F::Scalar;
  for_all_samples<F>([](const auto& s) {
    // lift^T (mass_block q'' - velocity_force - applied_force) is Euler's Jbar omega_bar' + ... - nbar
    const Vector3<S> n_bar = s.a_bar;
    const typename F::Unknown q_ddot = F::from_angular_acceleration(s.body, s.omega_bar_dot);
    const typename F::Unknown native = F::mass_block(s.body, s.J_bar) * q_ddot -
                                       F::velocity_force(s.body, s.J_bar) - F::applied_force(s.body, n_bar);
    const Vector3<S> euler = s.J_bar * s.omega_bar_dot + s.omega_bar.cross(s.J_bar * s.omega_bar) - n_bar;
    EXPECT_LE(distance(F::lift(s.body).transpose() * native, euler), roundings<S>(5000));
  });
}

TYPED_TEST(FormulationLaws, MassBlockCarriesTheRotationalEnergy) {
  using F = TypeParam;
  using S = typename F::Scalar;
  for_all_samples<F>([](const auto& s) {
    const typename F::Unknown q_dot = F::lift(s.body) * s.omega_bar;
    const auto M = F::mass_block(s.body, s.J_bar);
    const S twice = s.omega_bar.dot(s.J_bar * s.omega_bar);
    EXPECT_LE(std::abs(static_cast<double>(S(q_dot.dot(M * q_dot) - twice))), roundings<S>(1000));
    EXPECT_LE(distance(M, M.transpose()), roundings<S>(300));
  });
}

TYPED_TEST(FormulationLaws, AppliedForceDoesTheWorkOfItsMoment) {
  using F = TypeParam;
  using S = typename F::Scalar;
  for_all_samples<F>([](const auto& s) {
    const typename F::Unknown q_dot = F::lift(s.body) * s.omega_bar;
    const S work = F::applied_force(s.body, s.a_bar).dot(q_dot);
    EXPECT_LE(std::abs(static_cast<double>(S(work - s.a_bar.dot(s.omega_bar)))), roundings<S>(300));
  });
}

TYPED_TEST(FormulationLaws, DisplacementLeadsFromOnePlaceToTheOther) {
  using F = TypeParam;
  using S = typename F::Scalar;
  Random random(53);
  for_all_samples<F>([&](const auto& s) {
    const typename F::Flat from = F::flat_orientation(s.chart, s.p);
    const typename F::Unknown by = S(0.3) * random.vector<S, F::rotational_unknowns>();
    EXPECT_LE(distance(F::displacement(s.chart, from, F::displaced(s.chart, from, by)), by),
              roundings<S>(2000));
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
      const typename F::Flat from = F::flat_orientation(s.chart, s.p);
      const typename F::Unknown by = S(0.2) * random.vector<S, F::rotational_unknowns>();
      typename F::Flat at = F::displaced(s.chart, from, by);
      const typename F::Unknown v = F::flat_velocity(s.chart, s.q);
      const S h(1e-11);
      const auto after = [&](const S& t) {
        return F::displacement(s.chart, from, F::displaced(s.chart, at, (t * v).eval()));
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
    const typename F::Flat from = F::flat_orientation(s.chart, s.p);
    const S share(0.01);
    typename F::Unknown x = random.vector<S, F::rotational_unknowns>(), before = x;
    typename F::Flat at = F::displaced(s.chart, from, (share * x).eval());
    const typename F::Flat off = at;
    F::constrain(at, share, x);
    EXPECT_LE(distance(F::displaced(s.chart, off, (share * (x - before)).eval()), at), roundings<S>(100));
    typename F::Unknown v = random.vector<S, F::rotational_unknowns>(), change = F::Unknown::Zero();
    F::constrain_velocity(at, v, share, change);
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

// what a generalised force does along the increments of the reduced unknowns, and as a moment
TYPED_TEST(FormulationLaws, ReducedForceDoesTheSameWork) {
  using F = TypeParam;
  using S = typename F::Scalar;
  Random random(56);
  for_all_samples<F>([&](const auto& s) {
    const typename F::Reduced body{s.body};
    const typename F::Unknown force = random.vector<S, F::rotational_unknowns>();
    const Vector3<S> x = random.vector<S, 3>();
    const S work = force.dot(F::increment(body, x)), reduced = F::reduced(body, force).dot(x);
    EXPECT_LE(std::abs(static_cast<double>(S(work - reduced))), roundings<S>(300));
    const Vector3<S> moment = F::moment(body, F::reduced(body, F::applied_force(s.body, s.a_bar)));
    EXPECT_LE(distance(moment, s.a_bar), roundings<S>(1000));
  });
}

}  // namespace
}  // namespace trivium
