/// Rotation matrices, tilde matrices, and Euler parameters of a matrix.

#include "bodies/rotations/so3.hpp"

#include "bodies/numbers/scalar.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "bodies/testing/scalars.hpp"

namespace trivium {
namespace {

using test::distance, test::draw_euler_parameters, test::draw_vector, test::for_all, test::Random,
    test::roundings;

template <class S>
class Rotations : public testing::Test {};
TYPED_TEST_SUITE(Rotations, test::TestedScalars);

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

TYPED_TEST(Rotations, EulerParametersInvertTheRotationMatrix) {
  using S = TypeParam;
  for_all(
      [] {
        const Vector4<S> p = draw_euler_parameters<S>();
        const Vector4<S> found = euler_parameters(rotation_matrix(p));
        Eigen::Index largest;
        found.cwiseAbs().maxCoeff(&largest);
        RC_ASSERT(found[largest] > S(0));
        // p and -p describe the same rotation
        RC_ASSERT(std::min(distance(found, p), distance(found, -p)) <= roundings<S>(20));
      },
      1000);
}

TYPED_TEST(Rotations, EulerParametersOfHalfTurnsAndTheirNeighbours) {
  using S = TypeParam;
  Random random(1);
  for (int n = 0; n < 300; ++n) {
    Vector3<S> axis = n < 3 ? Vector3<S>(Vector3<S>::Unit(n)) : random.direction<S>();
    if (n % 7 == 3) axis[n % 3] = S(0);  // an axis in a coordinate plane: a second component of p is 0
    Vector4<S> p;
    p << (n % 2 ? S(0) : S(random.uniform(-1e-5, 1e-5))), axis;
    p /= p.norm();
    const Vector4<S> found = euler_parameters(rotation_matrix(p));
    EXPECT_LE(std::min(distance(found, p), distance(found, -p)), roundings<S>(20)) << "case " << n;
  }
}

TYPED_TEST(Rotations, ProductOfParametersIsProductOfRotations) {
  using S = TypeParam;
  for_all([] {
    const Vector4<S> p = draw_euler_parameters<S>(), q = draw_euler_parameters<S>();
    const Vector4<S> pq = multiply_parameters(p, q);
    RC_ASSERT(distance(rotation_matrix(pq), rotation_matrix(p) * rotation_matrix(q)) <= roundings<S>(40));
  });
}

}  // namespace
}  // namespace trivium
