/// Euler angles in all twelve sequences, also at and near their singularities.

#include "bodies/rotations/euler_angles.hpp"
#include "bodies/rotations/so3.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "bodies/testing/scalars.hpp"

namespace trivium {
namespace {

using test::distance, test::for_all, test::Random, test::roundings;

template <class S>
class EulerAngles : public testing::Test {};
TYPED_TEST_SUITE(EulerAngles, test::TestedScalars);

template <class S>
S pi() {
  using std::acos;
  return acos(S(-1));
}

TEST(EulerSequences, AreTheirAxesAsConstants) {
  for (const auto name : euler_sequence_names) {
    const EulerSequence sequence = *parse_euler_sequence(name);
    const EulerSequence constants = with_axes(sequence, []<int i, int j, int k>(Axes<i, j, k>) {
      return EulerSequence{{i, j, k}};
    });
    EXPECT_EQ(constants, sequence) << name;
  }
}

TYPED_TEST(EulerAngles, RotationIsTheProductOfThreeTurnsInTheStatedOrder) {
  using S = TypeParam;
  // 3-1-3 (Haug 9.3.41): column 3 of A depends only on the first two angles, row 3 only on the last two
  const Vector3<S> angles(S(0.3), S(0.5), S(0.7));
  const Matrix3<S> A = euler_rotation<S>({{2, 0, 2}}, angles);
  using std::cos, std::sin;
  const Vector3<S> third(sin(angles[0]) * sin(angles[1]), -cos(angles[0]) * sin(angles[1]), cos(angles[1]));
  EXPECT_LE(distance(A.col(2), third), roundings<S>(8));
  const Vector3<S> third_row(sin(angles[1]) * sin(angles[2]), sin(angles[1]) * cos(angles[2]),
                             cos(angles[1]));
  EXPECT_LE(distance(A.row(2).transpose(), third_row), roundings<S>(8));
}

TYPED_TEST(EulerAngles, GiveBackTheRotationInEverySequence) {
  using S = TypeParam;
  for_all(
      [] {
        const EulerSequence s = test::draw_sequence();
        const Matrix3<S> A = rotation_matrix(test::draw_euler_parameters<S>());
        const Vector3<S> angles = euler_angles(s, A);
        RC_ASSERT(distance(euler_rotation(s, angles), A) <= roundings<S>(30));
        const S middle = angles[1];
        if (s.is_symmetric())
          RC_ASSERT(middle >= S(0) && middle <= pi<S>());
        else
          RC_ASSERT(middle >= -pi<S>() / 2 && middle <= pi<S>() / 2);
      },
      1000);
}

TYPED_TEST(EulerAngles, OfARotationMadeFromAnglesAreThoseAngles) {
  using S = TypeParam;
  for_all(
      [] {
        const EulerSequence s = test::draw_sequence();
        Vector3<S> angles{test::draw_number<S>(3), test::draw_number<S>(), test::draw_number<S>(3)};
        if (s.is_symmetric()) angles[1] = S(1.5) + angles[1];
        RC_ASSERT(distance(euler_angles(s, euler_rotation(s, angles)), angles) <= roundings<S>(60));
      },
      1000);
}

TYPED_TEST(EulerAngles, GiveBackTheRotationAtAndNearTheSingularity) {
  using S = TypeParam;
  Random random(3);
  for (const auto name : euler_sequence_names) {
    const EulerSequence s = *parse_euler_sequence(name);
    for (int n = 0; n < 60; ++n) {
      const S offset = n % 4 == 0 ? S(0) : S(std::pow(10.0, -random.uniform(0, 30)));
      const S singular = s.is_symmetric() ? (n % 2 ? S(0) : pi<S>()) : (n % 2 ? S(1) : S(-1)) * pi<S>() / 2;
      const double third = random.uniform(-3, 3), first = random.uniform(-3, 3);
      const Vector3<S> angles(S(first), singular + offset, S(third));
      const Matrix3<S> A = euler_rotation(s, angles);
      EXPECT_LE(distance(euler_rotation(s, euler_angles(s, A)), A), roundings<S>(30))
          << name << " " << offset;
    }
  }
}

TEST(EulerSequences, NamesAreTheTwelveAndNoOthers) {
  for (const auto name : euler_sequence_names) {
    ASSERT_TRUE(parse_euler_sequence(name));
    EXPECT_EQ(parse_euler_sequence(name)->name(), name);
    EXPECT_EQ(parse_euler_sequence(name)->is_symmetric(), name[0] == name[2]);
  }
  for (const char* other : {"", "31", "113", "311", "333", "014", "3131", "zxz"})
    EXPECT_FALSE(parse_euler_sequence(other)) << other;
}

}  // namespace
}  // namespace trivium
