/// Laws of the Formulation concept, tested in every formulation: steps and displacements of an orientation.

#include "bodies/numbers/quad.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "formulations/testing/body_samples.hpp"

namespace trivium {
namespace {

using test::distance, test::for_all_samples, test::Random, test::roundings;

template <class F>
class FormulationDisplacements : public testing::Test {};
TYPED_TEST_SUITE(FormulationDisplacements, test::TestedFormulations, test::FormulationNames);

TYPED_TEST(FormulationDisplacements, LeadFromOnePlaceToTheOther) {
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

// the derivative of the displacement from a fixed orientation is displacement_rate; central differences in
// quad with h = 1e-11
TYPED_TEST(FormulationDisplacements, GrowAsTheBodyMoves) {
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

TYPED_TEST(FormulationDisplacements, MeetTheInternalRowByItsShare) {
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
