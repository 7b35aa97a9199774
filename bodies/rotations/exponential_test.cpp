/// The exponential map, its inverse (the rotation vector), and the rate of the rotation vector.

#include "bodies/numbers/quad.hpp"
#include "bodies/numbers/scalar.hpp"
#include "bodies/rotations/so3.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "bodies/testing/scalars.hpp"

namespace trivium {
namespace {

using test::distance, test::draw_number, test::draw_vector, test::for_all, test::Random, test::roundings;

template <class S>
class Exponential : public testing::Test {};
TYPED_TEST_SUITE(Exponential, test::TestedScalars);

TYPED_TEST(Exponential, TurnsByItsNormAboutItsAxis) {
  using S = TypeParam;
  using std::sin, std::cos;
  Random random(2);
  for (int n = 0; n < 300; ++n) {
    // sizes down to far below sqrt(u), where implementations often replace sin(x)/x by a series
    const S size = S(std::pow(10.0, -random.uniform(0, 12)));
    const Vector3<S> axis = random.direction<S>();
    const Vector4<S> p = exponential_parameters<S>(size * axis);
    const S half = size / 2;
    EXPECT_LE(static_cast<double>((p.template tail<3>() - sin(half) * axis).norm() / half), roundings<S>(20))
        << "size " << size;
    EXPECT_LE(std::abs(static_cast<double>(S(p[0] - cos(half)))), roundings<S>(10));
  }
  EXPECT_EQ(exponential_parameters<S>(Vector3<S>::Zero()), (Vector4<S>::Unit(0)));
}

TYPED_TEST(Exponential, AddsAboutOneAxis) {
  using S = TypeParam;
  for_all([] {
    const Vector3<S> phi = draw_vector<S, 3>(3);
    const S a = draw_number<S>(), b = draw_number<S>();
    const Vector4<S> product =
        multiply_parameters(exponential_parameters<S>(a * phi), exponential_parameters<S>(b * phi));
    RC_ASSERT(distance(product, exponential_parameters<S>((a + b) * phi)) <= roundings<S>(40));
  });
}

TYPED_TEST(Exponential, OfAnAxisIsTheAxisRotation) {
  using S = TypeParam;
  for_all([] {
    const int k = *rc::gen::inRange(0, 3);
    const S angle = draw_number<S>(7);
    const Matrix3<S> R = rotation_matrix(exponential_parameters<S>(angle * unit_axis<S>(k)));
    RC_ASSERT(distance(axis_rotation(k, angle), R) <= roundings<S>(40));
  });
}

TYPED_TEST(Exponential, IsInvertedByTheRotationVector) {
  using S = TypeParam;
  Random random(3);
  for (int n = 0; n < 300; ++n) {
    const S size = n == 0  ? S(0)
                   : n % 2 ? S(random.uniform(0.1, 3.1))
                           : S(std::pow(10.0, -random.uniform(0, 12)));
    const Vector3<S> phi = size * random.direction<S>();
    const Vector4<S> p = exponential_parameters(phi);
    for (const int sign : {1, -1})  // p and -p describe the same rotation
      EXPECT_LE(distance(rotation_vector<S>(S(sign) * p), phi), roundings<S>(40) * static_cast<double>(size))
          << size;
  }
}

// A(t) = exp(tilde(phi + t phi')) has angular velocity omega_bar: checked by central differences in Quad
TYPED_TEST(Exponential, RotationVectorRateIsThatOfATurningBody) {
  using S = TypeParam;
  Random random(4);
  for (int n = 0; n < 100; ++n) {
    const double size = n % 3 == 0 ? random.uniform(0.9, 1.1) : random.uniform(0, 5);
    const Vector3<Quad> phi = Quad(size) * random.direction<Quad>(), omega_bar = random.vector<Quad, 3>();
    const Vector3<Quad> rate = rotation_vector_rate(phi, omega_bar);
    const Quad h(1e-11);
    const auto turned = [&](const Quad& by) {
      return rotation_matrix(exponential_parameters<Quad>(phi + by * rate));
    };
    const Matrix3<Quad> W = turned(Quad(0)).transpose() * (turned(h) - turned(-h)) / (2 * h);
    EXPECT_LE(distance(W, tilde(omega_bar)), 1e-18) << size;
    const Vector3<S> in_s = rotation_vector_rate<S>(scalar_cast<S>(phi), scalar_cast<S>(omega_bar));
    EXPECT_LE(distance(scalar_cast<Quad>(in_s), rate), std::max(roundings<S>(200), roundings<Quad>(200)))
        << size;
  }
}

}  // namespace
}  // namespace trivium
