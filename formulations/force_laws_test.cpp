/// Laws of the Formulation concept, tested in every formulation: forces.

#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "formulations/testing/body_samples.hpp"

namespace trivium {
namespace {

using test::distance, test::for_all_samples, test::Random, test::roundings;

template <class F>
class FormulationForces : public testing::Test {};
TYPED_TEST_SUITE(FormulationForces, test::TestedFormulations, test::FormulationNames);

TYPED_TEST(FormulationForces, EquationsAreEulersInDisguise) {
  using F = TypeParam;
  using S = typename F::Scalar;
  for_all_samples<F>([](const auto& s) {
    // lift^T (mass_block q'' - velocity_force - applied_force) = J_bar omega_bar' +
    // omega_bar x J_bar omega_bar - n_bar
    const Vector3<S> n_bar = s.a_bar;
    const typename F::Unknown q_ddot = test::unknown_of<F>(s.body, s.omega_bar_dot);
    const typename F::Unknown native = F::mass_block(s.body, s.J_bar) * q_ddot -
                                       F::velocity_force(s.body, s.J_bar) - F::applied_force(s.body, n_bar);
    const Vector3<S> euler = s.J_bar * s.omega_bar_dot + s.omega_bar.cross(s.J_bar * s.omega_bar) - n_bar;
    EXPECT_LE(distance(F::lift(s.body).transpose() * native, euler), roundings<S>(5000));
  });
}

TYPED_TEST(FormulationForces, MassBlockCarriesTheRotationalEnergy) {
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

TYPED_TEST(FormulationForces, AppliedForceDoesTheWorkOfItsMoment) {
  using F = TypeParam;
  using S = typename F::Scalar;
  for_all_samples<F>([](const auto& s) {
    const typename F::Unknown q_dot = F::lift(s.body) * s.omega_bar;
    const S work = F::applied_force(s.body, s.a_bar).dot(q_dot);
    EXPECT_LE(std::abs(static_cast<double>(S(work - s.a_bar.dot(s.omega_bar)))), roundings<S>(300));
  });
}

// a force and its reduced force do the same work along an increment; moment() recovers an applied moment
TYPED_TEST(FormulationForces, ReducedForceDoesTheSameWork) {
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
