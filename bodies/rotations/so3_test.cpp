#include "bodies/rotations/so3.hpp"

#include "bodies/numbers/quad.hpp"
#include "bodies/numbers/real50.hpp"
#include "bodies/numbers/scalar.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"

namespace trivium {
namespace {

using test::distance, test::draw_euler_parameters, test::draw_vector, test::for_all, test::Random,
    test::roundings;

template <class S>
class Rotations : public testing::Test {};
using Scalars = testing::Types<float, double, Quad, Real50>;
TYPED_TEST_SUITE(Rotations, Scalars);

TYPED_TEST(Rotations, TildeIsTheCrossProduct) {
  using S = TypeParam;
  for_all([] {
    const Vector3<S> a = draw_vector<S, 3>(9), b = draw_vector<S, 3>(9);
    RC_ASSERT(tilde(a) * b == a.cross(b));
    RC_ASSERT(tilde(a).transpose() == -tilde(a));
  });
}

TYPED_TEST(Rotations, RotationIsEGTransposed) {
  using S = TypeParam;
  for_all([] {
    const Vector4<S> p = draw_euler_parameters<S>();
    const Matrix3<S> A = rotation_matrix(p);
    const Vector3<S> e = p.template tail<3>();
    // Haug (9.3.7): A = (2 e0^2 - 1) I + 2 (e e^T + e0 tilde e)
    const Matrix3<S> haug =
        (2 * p[0] * p[0] - 1) * Matrix3<S>::Identity() + 2 * (e * e.transpose() + p[0] * tilde(e));
    RC_ASSERT(distance(A, haug) <= roundings<S>(16));
    RC_ASSERT(distance(A * A.transpose(), Matrix3<S>::Identity()) <= roundings<S>(16));
    RC_ASSERT(static_cast<double>(A.determinant()) > 0.9);
  });
}

TYPED_TEST(Rotations, EAndGHaveOrthonormalRowsAndAnnihilateP) {
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

TYPED_TEST(Rotations, AngularVelocityIsTwiceGPDot) {
  using S = TypeParam;
  for_all([] {
    const Vector4<S> p = draw_euler_parameters<S>();
    const Vector3<S> omega_bar = draw_vector<S, 3>(4);
    const Vector4<S> p_dot = G_matrix(p).transpose() * omega_bar / 2;
    RC_ASSERT(distance(2 * G_matrix(p) * p_dot, omega_bar) <= roundings<S>(100));
    RC_ASSERT(distance(-2 * G_matrix(p_dot) * p, omega_bar) <= roundings<S>(100));
    // A' = A tilde(omega_bar), A' by the product rule on A = E G^T
    const Matrix3<S> A_dot =
        E_matrix(p_dot) * G_matrix(p).transpose() + E_matrix(p) * G_matrix(p_dot).transpose();
    RC_ASSERT(distance(A_dot, rotation_matrix(p) * tilde(omega_bar)) <= roundings<S>(100));
  });
}

TYPED_TEST(Rotations, AngularAccelerationIsTwiceGPDdot) {
  using S = TypeParam;
  for_all([] {
    const Vector4<S> p = draw_euler_parameters<S>();
    const Vector3<S> omega_bar = draw_vector<S, 3>(4), omega_bar_dot = draw_vector<S, 3>(4);
    const Vector4<S> p_dot = G_matrix(p).transpose() * omega_bar / 2;
    // p'' of a path on the sphere; A'' by the product rule gives omega_bar' independently
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

TYPED_TEST(Rotations, EulerParametersInvertTheRotationMatrix) {
  using S = TypeParam;
  for_all(
      [] {
        const Vector4<S> p = draw_euler_parameters<S>();
        const Vector4<S> found = euler_parameters(rotation_matrix(p));
        Eigen::Index largest;
        found.cwiseAbs().maxCoeff(&largest);
        RC_ASSERT(found[largest] > S(0));
        // p and -p are the same rotation
        RC_ASSERT(std::min(distance(found, p), distance(found, -p)) <= roundings<S>(20));
      },
      1000);
}

TYPED_TEST(Rotations, EulerParametersOfHalfTurnsAndTheirNeighbours) {
  using S = TypeParam;
  Random random(1);
  for (int n = 0; n < 300; ++n) {
    Vector3<S> axis = n < 3 ? Vector3<S>(Vector3<S>::Unit(n)) : random.direction<S>();
    if (n % 7 == 3) axis[n % 3] = S(0);  // an axis in a coordinate plane: one of the four vanishes too
    Vector4<S> p;
    p << (n % 2 ? S(0) : S(random.uniform(-1e-5, 1e-5))), axis;
    p /= p.norm();
    const Vector4<S> found = euler_parameters(rotation_matrix(p));
    EXPECT_LE(std::min(distance(found, p), distance(found, -p)), roundings<S>(20)) << "case " << n;
  }
}

TYPED_TEST(Rotations, ExponentialTurnsByItsNormAboutItsAxis) {
  using S = TypeParam;
  using std::sin, std::cos;
  Random random(2);
  for (int n = 0; n < 300; ++n) {
    // sizes down to far below the root of u, where a series would have to take over from sin(x)/x
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

TYPED_TEST(Rotations, ExponentialAboutOneAxisAdds) {
  using S = TypeParam;
  for_all([] {
    const Vector3<S> phi = draw_vector<S, 3>(3);
    const S a = test::draw_number<S>(), b = test::draw_number<S>();
    const Vector4<S> product =
        multiply_parameters(exponential_parameters<S>(a * phi), exponential_parameters<S>(b * phi));
    RC_ASSERT(distance(product, exponential_parameters<S>((a + b) * phi)) <= roundings<S>(40));
  });
}

TYPED_TEST(Rotations, ProductOfParametersIsProductOfRotations) {
  using S = TypeParam;
  for_all([] {
    const Vector4<S> p = draw_euler_parameters<S>(), q = draw_euler_parameters<S>();
    const Vector4<S> pq = multiply_parameters(p, q);
    RC_ASSERT(distance(rotation_matrix(pq), rotation_matrix(p) * rotation_matrix(q)) <= roundings<S>(40));
  });
}

TYPED_TEST(Rotations, AxisRotationIsTheExponentialOfItsAxis) {
  using S = TypeParam;
  for_all([] {
    const int k = *rc::gen::inRange(0, 3);
    const S angle = test::draw_number<S>(7);
    const Matrix3<S> R = rotation_matrix(exponential_parameters<S>(angle * unit_axis<S>(k)));
    RC_ASSERT(distance(axis_rotation(k, angle), R) <= roundings<S>(40));
  });
}

TYPED_TEST(Rotations, RotationVectorInvertsTheExponential) {
  using S = TypeParam;
  Random random(3);
  for (int n = 0; n < 300; ++n) {
    const S size = n == 0  ? S(0)
                   : n % 2 ? S(random.uniform(0.1, 3.1))
                           : S(std::pow(10.0, -random.uniform(0, 12)));
    const Vector3<S> phi = size * random.direction<S>();
    const Vector4<S> p = exponential_parameters(phi);
    for (const int sign : {1, -1})  // p and -p are the same rotation
      EXPECT_LE(distance(rotation_vector<S>(S(sign) * p), phi), roundings<S>(40) * static_cast<double>(size))
          << size;
  }
}

// A(t) = exp(tilde(phi + t phi')) turns with omega_bar, by differences in quad
TYPED_TEST(Rotations, RotationVectorRateIsThatOfATurningBody) {
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
