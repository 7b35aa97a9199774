/// Basic constraints equal their definitions and keep their laws; the laws detect constraints with one error.

#include "constraints/basic_constraint.hpp"

#include "bodies/numbers/quad.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "constraints/constraint_laws.hpp"
#include "constraints/constraint_row.hpp"
#include "constraints/testing/moving_plain_body.hpp"

namespace trivium {
namespace {

using test::distance, test::Random, test::RowErrors, test::roundings, test::Taylor;

template <class S>
class BasicConstraints : public testing::Test {};
using Scalars = testing::Types<double, Quad>;
TYPED_TEST_SUITE(BasicConstraints, Scalars);

TYPED_TEST(BasicConstraints, PhiEqualsItsDefinition) {
  using S = TypeParam;
  Random random(21);
  for (int n = 0; n < 50; ++n) {
    const auto i = test::random_plain_body<S>(random).now, j = test::random_plain_body<S>(random).now;
    const Vector3<S> a = random.vector<S, 3>(), b = random.vector<S, 3>(), c = random.vector<S, 3>();
    const S t(random.uniform());
    const TimeFunction f = TimeFunction::Polynomial{{0.5, -2, 3}};
    const S f_t = f(t).f;
    const BodyPair pair{0, 1};
    const auto phi = [&](const BasicConstraint<S>& constraint) {
      return evaluate_row(constraint, i, j, t).phi;
    };
    const auto d = [&](const Vector3<S>& s_i, const Vector3<S>& s_j) {
      return Vector3<S>((j.r + j.A * s_j) - (i.r + i.A * s_i));
    };
    const auto near = [](const S& x, const S& y) {
      return std::abs(static_cast<double>(S(x - y))) <= roundings<S>(100);
    };
    EXPECT_TRUE(near(phi(DP1<S>{pair, a, b, f}), (i.A * a).dot(j.A * b) - f_t));
    EXPECT_TRUE(near(phi(DP2<S>{pair, a, b, c, f}), (i.A * a).dot(d(b, c)) - f_t));
    EXPECT_TRUE(near(phi(D<S>{pair, a, b, f}), d(a, b).squaredNorm() - f_t));
    EXPECT_TRUE(near(phi(CD<S>{pair, a, b, c, f}), a.dot(d(b, c)) - f_t));
    using std::cos, std::sin;
    const Vector3<S> w = -sin(f_t) * (i.A * a) + cos(f_t) * (i.A * b);
    EXPECT_TRUE(near(phi(TurningDP1<S>{pair, a, b, c, f}), w.dot(j.A * c)));
  }
}

TYPED_TEST(BasicConstraints, RowsAreTheDerivativesOfPhiInCoordinatesOfTheirOwn) {
  using S = TypeParam;
  Random random(22);
  for (int kind = 0; kind < test::basic_kinds; ++kind) {
    RowErrors worst;
    for (int n = 0; n < 100; ++n) {
      const auto i = test::random_plain_body<S>(random), j = test::random_plain_body<S>(random);
      measure_row(kind, n, i, j, Taylor<S>::parameter(S(random.uniform())), worst);
    }
    EXPECT_LE(worst.value, roundings<S>(100)) << test::basic_kind_name(kind);
    EXPECT_LE(worst.velocity, roundings<S>(1000)) << test::basic_kind_name(kind);
    EXPECT_LE(worst.acceleration, roundings<S>(3000)) << test::basic_kind_name(kind);
    EXPECT_LE(worst.row_acceleration, roundings<S>(3000)) << test::basic_kind_name(kind);
  }
}

// The following constraints each violate one law.

/// Rotates its vector by alpha(2 t).
template <class S>
struct HastyDP1 : TurningDP1<S> {
  template <BodyKinematics Body, class Use>
  auto with_features(const Body& on_i, const Body& on_j, const S& t, const Use& use) const {
    return TurningDP1<S>::with_features(on_i, on_j, S(2 * t), use);
  }
};
/// Its keys omit the second vector.
template <class S>
struct SecretiveDP1 : DP1<S> {
  static void keys(auto&& show, auto&... c) {
    show.vector_i(c.a_bar_i...);
    show.may("f", c.f...);
  }
};

/// `function` returns a function other than f.
template <class S>
struct MisleadingDP1 : DP1<S> {
  const TimeFunction& function() const {
    static const TimeFunction other = 7.0;
    return other;
  }
};
/// `is_of_angle` is false for an angle.
template <class S>
struct LongDP1 : DP1<S> {
  static constexpr bool is_of_angle = false;
};
/// `vanishes` is true at every state.
template <class S>
struct VanishingDP1 : DP1<S> {
  bool vanishes(const auto&, const auto&, const S&) const { return true; }
};
/// `sees_relative_motion` is true, but the vector c is fixed in the global frame.
template <class S>
struct BlindCD : CD<S> {
  static constexpr bool sees_relative_motion = true;
};

TYPED_TEST(BasicConstraints, KeepTheirLawsAndLawsFindOneThatBreaksThem) {
  using S = TypeParam;
  Random random(24);
  for (int n = 0; n < 50; ++n) {
    const auto i = test::random_plain_body<S>(random).now, j = test::random_plain_body<S>(random).now;
    const S t(random.uniform());
    for (int kind = 0; kind < test::basic_kinds; ++kind) {
      const auto laws = [&](const auto& row) { return broken_laws(row, i, j, t); };
      for (const BrokenLaw& law : std::visit(laws, test::sample_constraint<S>(kind, n)))
        ADD_FAILURE() << test::basic_kind_name(kind) << ": " << law.text();
    }
    const BodyPair pair{0, 1};
    const Vector3<S> a = random.vector<S, 3>(), b = random.vector<S, 3>(), c = random.vector<S, 3>();
    const TimeFunction alpha = TimeFunction::Polynomial{{0.3, 2}};
    EXPECT_FALSE(broken_laws(HastyDP1<S>{{pair, a, b, c, alpha}}, i, j, t).empty());
    EXPECT_FALSE(broken_laws(SecretiveDP1<S>{{pair, a, b, alpha}}, i, j, t).empty());
    EXPECT_FALSE(broken_laws(BlindCD<S>{{pair, a, b, c, alpha}}, i, j, t).empty());
    EXPECT_FALSE(broken_laws(MisleadingDP1<S>{{pair, a, b, alpha}}, i, j, t).empty());
    EXPECT_FALSE(broken_laws(LongDP1<S>{{pair, a, b, alpha}}, i, j, t).empty());
    EXPECT_FALSE(broken_laws(VanishingDP1<S>{{pair, a, b, alpha}}, i, j, t).empty());
  }
}

TYPED_TEST(BasicConstraints, RowScaleKeepsNaNAndReplacesZeroByOne) {
  using S = TypeParam;
  const Vector3<S> x = Vector3<S>::UnitX(), none = Vector3<S>::Zero();
  const Vector3<S> broken = x * std::numeric_limits<S>::quiet_NaN();
  const auto scale_of = [](const BasicConstraint<S>& row) { return row_scale(row, S(0)); };
  EXPECT_EQ(scale_of(DP1<S>{{0, 1}, none, x, {}}), S(1));
  const S scale = scale_of(DP1<S>{{0, 1}, broken, x, {}});
  EXPECT_TRUE(scale != scale);
}

TYPED_TEST(BasicConstraints, KeepTheirLawsAtRestAndWhenSmall) {
  using S = TypeParam;
  const PlainBody<S> at_rest;
  const Vector3<S> x = Vector3<S>::UnitX(), tiny = S(1e-9) * Vector3<S>(S(1), S(2), S(-1));
  const Vector3<S> across = S(1e-9) * Vector3<S>(S(1), S(0), S(1));
  EXPECT_TRUE(broken_laws(DP1<S>{{0, 1}, x, x, 2.0}, at_rest, at_rest, S(0)).empty());
  Random random(25);
  const auto i = test::random_plain_body<S>(random).now, j = test::random_plain_body<S>(random).now;
  const TimeFunction alpha = TimeFunction::Polynomial{{0.3, 2}};
  EXPECT_TRUE(broken_laws(TurningDP1<S>{{0, 1}, tiny, across, tiny, alpha}, i, j, S(0.1)).empty());
  EXPECT_FALSE(broken_laws(HastyDP1<S>{{{0, 1}, tiny, across, tiny, alpha}}, i, j, S(0.1)).empty());
}

TYPED_TEST(BasicConstraints, NuIsZeroWhereNothingIsPrescribed) {
  using S = TypeParam;
  Random random(23);
  const auto i = test::random_plain_body<S>(random).now, j = test::random_plain_body<S>(random).now;
  const Vector3<S> a = random.vector<S, 3>(), b = random.vector<S, 3>(), c = random.vector<S, 3>();
  const BodyPair pair{0, 1};
  const BasicConstraint<S> rows[] = {DP1<S>{pair, a, b, 0.5}, DP2<S>{pair, a, b, c, 0.5},
                                     D<S>{pair, a, b, 0.5}, CD<S>{pair, a, b, c, 0.5},
                                     TurningDP1<S>{pair, a, b, c, 0.5}};
  for (const auto& row : rows) EXPECT_EQ(evaluate_row(row, i, j, S(1)).nu, S(0));
}

template <class S>
class Features : public testing::Test {};
TYPED_TEST_SUITE(Features, Scalars);

/// Rate and acceleration are the derivatives of the value; `along` is the feature `now` over Taylor.
template <class S, class Now, class Along, class Moving>
void expect_derivatives(const Now& now, const Along& along, const Moving& i, const Moving& j) {
  EXPECT_LE(distance(now.rate(), test::first_derivative<S, 3, 1>(along.value())), roundings<S>(200));
  EXPECT_LE(distance(now.acceleration(i.acceleration, j.acceleration),
                     test::second_derivative<S, 3, 1>(along.value())),
            roundings<S>(1000));
}

/// rate = Jacobian q' + drift, tested for the three components w = e_x, e_y, e_z.
template <class S, class Feature, class Moving>
void expect_jacobian_is_rate(const Feature& x, const Moving& i, const Moving& j) {
  for (int k = 0; k < 3; ++k) {
    const Vector3<S> w = Vector3<S>::Unit(k);
    ConstraintRow<S, 3> row;
    x.add_jacobian(w, row);
    const S rate = test::row_times(row, i.velocity, j.velocity) + x.drift_along(w);
    EXPECT_LE(std::abs(static_cast<double>(S(rate - x.rate()[k]))), roundings<S>(200));
  }
}

TYPED_TEST(Features, RateJacobianAndBiasAreThoseOfTheValue) {
  using S = TypeParam;
  using T = Taylor<S>;
  using Now = PlainBody<S>;
  using Along = PlainBody<T>;
  Random random(24);
  for (int n = 0; n < 50; ++n) {
    const auto i = test::random_plain_body<S>(random), j = test::random_plain_body<S>(random);
    const Vector3<S> a = random.vector<S, 3>(), b = random.vector<S, 3>(), c = random.vector<S, 3>();
    const auto a_T = test::constant<S, 3, 1>(a), b_T = test::constant<S, 3, 1>(b);

    const BodyVectorFeature<Now, End::i> on_i(i.now, a);
    expect_derivatives<S>(on_i, BodyVectorFeature<Along, End::i>(i.along, a_T), i, j);
    expect_jacobian_is_rate<S>(on_i, i, j);
    const BodyVectorFeature<Now, End::j> on_j(j.now, a);
    expect_derivatives<S>(on_j, BodyVectorFeature<Along, End::j>(j.along, a_T), i, j);
    expect_jacobian_is_rate<S>(on_j, i, j);

    const PointOffsetFeature<Now> offset(i.now, a, j.now, b);
    expect_derivatives<S>(offset, PointOffsetFeature<Along>(i.along, a_T, j.along, b_T), i, j);
    expect_jacobian_is_rate<S>(offset, i, j);

    // a vector that moves relative to its body: a_bar(t) = a + b t + c t^2 / 2
    const MovingVectorFeature<Now, End::i> moving(i.now, a, b, c);
    const auto path = test::taylor<S, 3, 1>(a, b, c);
    expect_derivatives<S>(moving, BodyVectorFeature<Along, End::i>(i.along, path), i, j);
    expect_jacobian_is_rate<S>(moving, i, j);
  }
}

}  // namespace
}  // namespace trivium
