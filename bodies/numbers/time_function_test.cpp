/// Functions of time: their derivatives, the values of every kind, and phases after many turns.

#include "bodies/numbers/time_function.hpp"

#include "bodies/numbers/quad.hpp"
#include "bodies/numbers/real50.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "bodies/testing/taylor.hpp"

namespace trivium {
namespace {

using test::for_all, test::Random, test::roundings, test::Taylor;
using TF = TimeFunction;

/// Every kind of function, alone and nested.
struct Case {
  const char* name;
  TF f;
};
std::vector<Case> cases() {
  const TF polynomial = TF::Polynomial{{0.3, -1.2, 0.7, 0.25, -0.11}};
  const TF harmonic = TF::Harmonic{0.4, 1.3, 2.1, -0.6};
  const TF step = TF::Step5{-0.5, 0.2, 1.75, 2.9};
  const TF sine = TF::Sin{{polynomial}}, cosine = TF::Cos{{harmonic}};
  const TF sum = TF::Sum{{polynomial, harmonic, TF(3.5), step}};
  const TF product = TF::Product{{polynomial, harmonic, step, TF(-2)}};
  return {
      {"number", TF(2.75)},
      {"polynomial", polynomial},
      {"constant polynomial", TF::Polynomial{{4}}},
      {"empty polynomial", TF::Polynomial{{}}},
      {"harmonic", harmonic},
      {"step5", step},
      {"sin", sine},
      {"cos", cosine},
      {"sum", sum},
      {"empty sum", TF::Sum{{}}},
      {"product", product},
      {"empty product", TF::Product{{}}},
      {"piecewise", TF::Piecewise{{0.2, 1.1}, {polynomial, sine, product}}},
      {"nested", TF::Sin{{TF::Product{{sum, TF::Cos{{TF::Sum{{step, sine}}}}}}}}},
      {"product of sums of products", TF::Product{{TF::Sum{{product, cosine}}, TF::Sum{{sine, harmonic}}}}}};
}

template <class S>
class TimeFunctions : public testing::Test {};
using Scalars = testing::Types<double, Quad, Real50>;
TYPED_TEST_SUITE(TimeFunctions, Scalars);

TYPED_TEST(TimeFunctions, DerivativesAreThoseOfTheValue) {
  using S = TypeParam;
  Random random(11);
  for (const Case& c : cases())
    for (int n = 0; n < 50; ++n) {
      const S t(random.uniform(-1, 2.5));
      const Jet<S> jet = c.f(t);
      const Taylor<S> value = c.f(Taylor<S>::parameter(t)).f;
      const double size =
          1 + std::abs(static_cast<double>(value.d2)) + std::abs(static_cast<double>(value.d1));
      EXPECT_LE(std::abs(static_cast<double>(S(jet.f - value.d0))), roundings<S>(20) * size) << c.name;
      EXPECT_LE(std::abs(static_cast<double>(S(jet.f_t - value.d1))), roundings<S>(200) * size) << c.name;
      EXPECT_LE(std::abs(static_cast<double>(S(jet.f_tt - value.d2))), roundings<S>(2000) * size) << c.name;
    }
}

/// The same law, checked by central differences instead of Taylor arithmetic. With 50 digits and h = 1e-12
/// the truncation error of order h^2 dominates.
TEST(TimeFunctionValues, DerivativesAreLimitsOfDifferences) {
  Random random(12);
  const Real50 h(1e-12);
  for (const Case& c : cases())
    for (int n = 0; n < 20; ++n) {
      const Real50 t(random.uniform(-1, 2.5));
      const Jet<Real50> jet = c.f(t);
      const Real50 up = c.f(Real50(t + h)).f, down = c.f(Real50(t - h)).f;
      EXPECT_LE(std::abs(static_cast<double>(Real50((up - down) / (2 * h) - jet.f_t))), 1e-18) << c.name;
      EXPECT_LE(std::abs(static_cast<double>(Real50((up - 2 * jet.f + down) / (h * h) - jet.f_tt))), 1e-16)
          << c.name;
    }
}

TEST(TimeFunctionValues, AreTheOnesOfTheSceneFormat) {
  const double t = 0.7;
  EXPECT_DOUBLE_EQ(TF(2.5)(t).f, 2.5);
  EXPECT_DOUBLE_EQ((TF(TF::Polynomial{{1, 2, 3}})(t).f), 1 + 2 * t + 3 * t * t);
  EXPECT_DOUBLE_EQ((TF(TF::Harmonic{1, 2, 3, 4})(t).f), 1 + 2 * std::sin(3 * t + 4));
  EXPECT_DOUBLE_EQ((TF(TF::Sin{{TF(0.3)}})(t).f), std::sin(0.3));
  EXPECT_DOUBLE_EQ((TF(TF::Cos{{TF::Polynomial{{0, 1}}}})(t).f), std::cos(t));
  EXPECT_DOUBLE_EQ((TF(TF::Sum{{TF(1), TF(2), TF(4)}})(t).f), 7);
  EXPECT_DOUBLE_EQ((TF(TF::Product{{TF(2), TF(3), TF(4)}})(t).f), 24);
}

TEST(TimeFunctionValues, OfPiecesAreThoseOfTheLaterOneFromItsTimeOn) {
  const TF f = TF::Piecewise{{1, 2}, {TF::Polynomial{{0, 1}}, TF::Polynomial{{-2, 3}}, TF(4)}};
  EXPECT_EQ(f(0.5).f, 0.5);
  EXPECT_EQ(f(std::nextafter(1.0, 0.0)).f_t, 1);
  EXPECT_EQ(f(1.0).f_t, 3);
  EXPECT_EQ(f(2.0).f, 4);
  EXPECT_EQ(f(2.0).f_t, 0);
  std::vector<double> times;
  f.append_kinks(times);
  EXPECT_EQ(times, (std::vector<double>{1, 2}));
  EXPECT_FALSE(f.is_constant());
  EXPECT_FALSE((TF(TF::Piecewise{{1}, {TF(2), TF(3)}}).is_constant()));
  EXPECT_TRUE((TF(TF::Piecewise{{1}, {TF(2), TF(2)}}).is_constant()));
}

TEST(TimeFunctionValues, OnlyANumberIsKnownToBeConstant) {
  EXPECT_TRUE(TF().is_number());
  EXPECT_TRUE(TF(3.0).is_number());
  EXPECT_FALSE(TF(TF::Polynomial{{3}}).is_number());
}

TYPED_TEST(TimeFunctions, Step5IsTwiceContinuouslyDifferentiableAndMonotone) {
  using S = TypeParam;
  for_all([] {
    const double t0 = test::draw_number<double>(4), length = *rc::gen::inRange(1, 2000) / 256.0,
                 f0 = test::draw_number<double>(4), f1 = test::draw_number<double>(4);
    const TF f = TF::Step5{t0, f0, t0 + length, f1};
    // x = 1e-6 of the length inside each end, |f - f_end|, |f'|, |f''| are 10 x^3, 30 x^2, 60 x of the rise
    const S x(1e-6), T(length);
    for (const bool end : {false, true}) {
      const Jet<S> inside = f(S(end ? S(S(t0) + T) - x * T : S(t0) + x * T));
      const double rise = std::abs(f1 - f0), slack = roundings<S>(100) * (10 + std::abs(t0) / length);
      RC_ASSERT(std::abs(static_cast<double>(S(inside.f - S(end ? f1 : f0)))) <= 11e-18 * rise + slack);
      RC_ASSERT(std::abs(static_cast<double>(S(inside.f_t * T))) <= 31e-12 * rise + slack);
      RC_ASSERT(std::abs(static_cast<double>(S(inside.f_tt * T * T))) <= 61e-6 * rise + slack * 60);
      const Jet<S> outside = f(S(end ? S(S(t0) + T) + x : S(t0) - x));
      RC_ASSERT(outside.f == S(end ? f1 : f0));
      RC_ASSERT(outside.f_t == S(0));
      RC_ASSERT(outside.f_tt == S(0));
    }
    const Jet<S> middle = f(S(S(t0) + T / 2));
    RC_ASSERT(std::abs(static_cast<double>(S(2 * middle.f - S(f0) - S(f1)))) <= roundings<S>(100));
    for (int k = 1; k < 16; ++k) RC_ASSERT(f(S(S(t0) + T * k / 16)).f_t * S(f1 - f0) >= S(0));
  });
}

TEST(TimeFunction, KeepsItsDigitsHoweverManyTurnsItHasMade) {
  const TF harmonic = TF::Harmonic{0, 1, 314.159, 0.7}, sine = TF::Sin{{TF::Polynomial{{0.3, 101.7, -1.3}}}};
  for (const double t : {10.0, 612.7, 86400.1})
    for (const TF& f : {harmonic, sine}) {
      const Jet<double> jet = f(t);
      const Jet<Quad> exact = f(Quad(t));
      EXPECT_NEAR(jet.f, static_cast<double>(exact.f), 1e-15) << t;
      EXPECT_NEAR(jet.f_t, static_cast<double>(exact.f_t), 1e-15 * std::abs(314.159 + 3 * t)) << t;
    }
}

// Of such an angle g not even the revolution survives rounding. The correction, of size g u, is rounded too.
TEST(TimeFunction, KeepsItsDigitsWhereTheAngleIsRoundedByRadians) {
  for (const double speed : {1e12, 1e17, 1e18})
    for (const double t : {0.7, 1.3, 611.9}) {
      const TF harmonic = TF::Harmonic{0, 1, speed, 0.7};
      const double u = unit_roundoff<double>();
      EXPECT_NEAR(harmonic(t).f, static_cast<double>(harmonic(Real50(t)).f), 1e-15 + speed * t * u * u)
          << speed << ", " << t;
    }
}

}  // namespace
}  // namespace trivium
