/// The choice of an Euler sequence and a re-framing by the distance from the singularity.

#include "formulations/euler_chart_choice.hpp"

#include "bodies/rotations/euler_angles.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "formulations/equations_of_motion.hpp"
#include "formulations/r_epsilon_omega_first.hpp"
#include "formulations/r_p.hpp"

namespace trivium {
namespace {

using test::distance, test::for_all, test::Random, test::roundings;

/// Distance from the singularity, computed from the angles: |sin theta| or |cos theta| of the middle angle.
double middle_angle_distance(const EulerSequence& s, const Matrix3<double>& A) {
  const double theta = euler_angles(s, A)[1];
  return std::abs(s.is_symmetric() ? std::sin(theta) : std::cos(theta));
}

TEST(EulerChart, DistanceIsThatOfTheMiddleAngle) {
  for_all([] {
    const EulerSequence s = test::draw_sequence();
    const Matrix3<double> A = rotation_matrix(test::draw_euler_parameters<double>());
    RC_ASSERT(std::abs(distance_from_singularity(s, A) - middle_angle_distance(s, A)) <= 1e-14);
  });
}

TEST(EulerChart, IsTheFirstOfTheListThatKeepsItsDistance) {
  for_all(
      [] {
        const EulerSequence s = test::draw_sequence();
        const Vector4<double> p = test::draw_euler_parameters<double>();
        const auto chart = choose_euler_chart<double>({s, true}, p);
        const Matrix3<double> A = rotation_matrix(p);
        RC_ASSERT(chart.sequence == s);
        RC_ASSERT(chart.C == reframing_rotation<double>(chart.reframing));
        RC_ASSERT(middle_angle_distance(s, A * chart.C.transpose()) >= 0.3 - 1e-14);
        for (int earlier = 0; earlier < chart.reframing; ++earlier)
          RC_ASSERT(middle_angle_distance(s, A * reframing_rotation<double>(earlier).transpose()) <=
                    0.3 + 1e-14);
      },
      5000);
}

TEST(EulerChart, AlwaysExistsEvenWhereEverySequenceIsSingular) {
  // the 24 orientations of a cube, which are singular for most sequences, and orientations near them
  Random random(71);
  for (const auto name : euler_sequence_names)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 16; ++j)
        for (const double offset : {0.0, 1e-9, 1e-3}) {
          const Matrix3<double> A =
              axis_rotation(i, j % 4 * std::acos(0.0)) * axis_rotation((i + 1) % 3, j / 4 * std::acos(0.0)) *
              rotation_matrix(exponential_parameters<double>(offset * random.direction<double>()));
          const EulerSequence s = *parse_euler_sequence(name);
          const auto chart = choose_euler_chart<double>({s, true}, euler_parameters(A));
          EXPECT_GE(middle_angle_distance(s, A * chart.C.transpose()), 0.3 - 1e-14);
        }
}

TEST(EulerChart, ReframingsAreExactQuarterTurns) {
  for (int k = 0; k < static_cast<int>(reframings.size()); ++k) {
    const Matrix3<double> C = reframing_rotation<double>(k);
    if (k == 0)
      EXPECT_EQ(C, (Matrix3<double>::Identity()));
    else
      EXPECT_LE(distance(C, axis_rotation(reframings[k].axis, std::acos(0.0))), 1e-16);
    EXPECT_EQ(C * C.transpose(), (Matrix3<double>::Identity()));
    EXPECT_EQ(C * C * C * C, (Matrix3<double>::Identity()));
  }
}

TEST(EulerChart, NameTellsSequenceAndReframing) {
  const EulerSequence s313 = *parse_euler_sequence("313");
  const Vector4<double> upright = Vector4<double>::Unit(0);
  EXPECT_EQ(choose_euler_chart<double>({s313, true}, upright).name(), "313 Rx(90)");
  const Vector4<double> tilted = exponential_parameters<double>({0.5, 0, 0});
  EXPECT_EQ(choose_euler_chart<double>({s313, true}, tilted).name(), "313");
  EXPECT_EQ(choose_euler_chart<double>({*parse_euler_sequence("321"), true}, upright).name(), "321");
}

TEST(EulerChart, RawOneStaysWhateverTheDistance) {
  const EulerSequence s = *parse_euler_sequence("313");
  for (const double tilt : {0.2, 1e-3, 1e-9}) {
    const auto chart = choose_euler_chart<double>({s, false}, exponential_parameters<double>({tilt, 0, 0}));
    EXPECT_EQ(chart.reframing, 0);
    EXPECT_EQ(chart.C, (Matrix3<double>::Identity()));
  }
}

template <class F>
std::string chart_error(const Mechanism<double>& mechanism, const MechanismState<double>& state,
                        const ChartOptions& options) {
  try {
    to_coordinates<F>(mechanism, state, options);
  } catch (const ModelError& error) {
    return error.what();
  }
  return "";
}

TEST(EulerChart, SingularRawOneIsAnErrorThatNamesTheBodyAndOnlyOfFormulationsWithCharts) {
  Mechanism<double> mechanism;
  mechanism.body_names = {"upright", "tilted", "spinning top", "ground"};
  mechanism.bodies.resize(3);
  MechanismState<double> state;
  state.pose.resize(3);
  state.twist.resize(3);
  state.pose[0].p = state.pose[1].p = exponential_parameters<double>({0.5, 0, 0});
  state.pose[2].p = exponential_parameters<double>({0, 0, 0.7});  // 3-1-3: sin(theta) = 0
  const ChartOptions raw{*parse_euler_sequence("313"), false};
  for (const std::string& message : {chart_error<REpsilon<double>>(mechanism, state, raw),
                                     chart_error<REpsilonOmegaFirst<double>>(mechanism, state, raw)}) {
    EXPECT_NE(message.find("\"spinning top\""), std::string::npos) << message;
    EXPECT_NE(message.find("313"), std::string::npos) << message;
    EXPECT_NE(message.find("|sin theta|"), std::string::npos) << message;
  }
  EXPECT_EQ(chart_error<ROmega<double>>(mechanism, state, raw), "");
  EXPECT_EQ(chart_error<RP<double>>(mechanism, state, raw), "");
  const ChartOptions reframed{*parse_euler_sequence("313"), true};
  EXPECT_EQ(chart_error<REpsilon<double>>(mechanism, state, reframed), "");
}

}  // namespace
}  // namespace trivium
