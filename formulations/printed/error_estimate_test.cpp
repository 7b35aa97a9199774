/// The error estimate covers the true error in easy and difficult states, and is not much larger. The
/// solution in quad precision is taken as exact.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "bodies/numbers/quad.hpp"
#include "bodies/numbers/scalar.hpp"
#include "bodies/rotations/so3.hpp"
#include "bodies/testing/random.hpp"
#include "formulations/side_by_side.hpp"
#include "formulations/testing/random_mechanism.hpp"
#include "formulations/testing/solve_scene.hpp"
#include "scenes/testing/scene_builders.hpp"

namespace trivium {
namespace {

/// Random states with one kind of difficulty.
struct Hardship {
  const char* name;
  ChartOptions charts;
  double hardest;  ///< some state has at least this error of lambda in r-epsilon
  test::MechanismOptions (*options)(test::Random&);
};

constexpr ChartOptions reframed{EulerSequence{{2, 0, 2}}, true}, raw{EulerSequence{{2, 0, 2}}, false};

test::MechanismOptions any(test::Random& random) {
  return {.bodies = 1 + random.index(3), .closings = random.index(2), .driven = random.chance(0.3)};
}

const Hardship hardships[] = {
    {"none", reframed, 1e-15, any},
    {"gimbal lock in a raw chart", raw, 1e-3,
     [](test::Random& random) {
       auto o = any(random);
       o.gimbal_distance = std::pow(10.0, -random.uniform(1, 7));
       return o;
     }},
    {"mass ratios up to 1e12", reframed, 1e-15,
     [](test::Random& random) {
       auto o = any(random);
       o.bodies = 3;
       o.mass_decades = 6;
       return o;
     }},
    {"nearly dependent rows", reframed, 1e-11,
     [](test::Random& random) {
       test::MechanismOptions o{.bodies = 2 + random.index(2), .closings = 0};
       o.near_rows = std::pow(10.0, -random.uniform(1, 6));
       return o;
     }},
    {"redundant rows", reframed, 1e-14,
     [](test::Random& random) {
       test::MechanismOptions o{.bodies = 2 + random.index(2), .closings = random.index(2)};
       o.doubled = 1;
       return o;
     }},
};

PhysicalSolution<Quad> in_quad(const PhysicalSolution<double>& s) {
  PhysicalSolution<Quad> out;
  for (std::size_t b = 0; b < s.r_ddot.size(); ++b) {
    out.r_ddot.push_back(scalar_cast<Quad>(s.r_ddot[b]));
    out.omega_bar_dot.push_back(scalar_cast<Quad>(s.omega_bar_dot[b]));
  }
  out.lambda = scalar_cast<Quad>(s.lambda);
  return out;
}

/// Ratios estimate / max(true error, u) of one formulation over many states.
struct Ratios {
  std::vector<double> lambda, acceleration;
};

void expect_honest(std::vector<double> ratios, const std::string& what) {
  ASSERT_FALSE(ratios.empty()) << what;
  std::sort(ratios.begin(), ratios.end());
  const auto covered = std::count_if(ratios.begin(), ratios.end(), [](double r) { return r >= 1; });
  EXPECT_GE(static_cast<double>(covered), 0.99 * static_cast<double>(ratios.size()))
      << what << ": " << ratios.size() << " states, the worst ratio " << ratios.front();
  EXPECT_LE(ratios[ratios.size() / 2], 100) << what;
}

class ErrorEstimate : public testing::TestWithParam<int> {};

TEST_P(ErrorEstimate, CoversTheTrueErrorAndIsWithinAHundredOfIt) {
  const Hardship& hardship = hardships[GetParam()];
  constexpr int states = 200;
  const double u = unit_roundoff<double>();
  std::map<std::string, Ratios> ratios;
  std::map<std::string, double> worst;
  test::Random random(1000 + GetParam());
  for (int n = 0; n < states; ++n) {
    const auto scene = test::random_scene(10000 * GetParam() + n, hardship.options(random));
    SolveOptions options;
    options.charts = hardship.charts;
    const auto result = test::solve_scene<double>(scene, options);
    SolveOptions exactly;
    exactly.formulations = {"r-omega"};
    const auto truth = test::solve_scene<Quad>(scene, exactly, false);
    const PhysicalSolution<Quad>& exact = truth.formulations[0].solution;
    for (const auto& formulation : result.formulations) {
      ASSERT_EQ(formulation.error, "");
      const PhysicalSolution<Quad> found = in_quad(formulation.solution);
      const double lambda = lambda_distance(truth.rows, found.lambda, exact.lambda),
                   acceleration = acceleration_distance(truth.rows, found, exact).all;
      if (lambda > worst[formulation.name]) worst[formulation.name] = lambda;
      ratios[formulation.name].lambda.push_back(formulation.estimate.lambda / std::max(lambda, u));
      ratios[formulation.name].acceleration.push_back(formulation.estimate.acceleration /
                                                      std::max(acceleration, u));
    }
  }
  // the states are as difficult as the table says
  EXPECT_GE(worst["r-epsilon"], hardship.hardest) << hardship.name;
  for (const auto& [name, r] : ratios) {
    expect_honest(r.lambda, std::string(hardship.name) + ", lambda in " + name);
    expect_honest(r.acceleration, std::string(hardship.name) + ", acceleration in " + name);
  }
}

TEST(GimbalLock, EstimateOfASolutionWithoutDigitsSaysSo) {
  for (int seed = 0; seed < 60; ++seed) {
    test::MechanismOptions options{.bodies = 1, .closings = 0};
    options.gimbal_distance = std::pow(10.0, -7.0 - 0.12 * seed);
    const auto scene = test::random_scene(7000 + seed, options);
    SolveOptions solve;
    solve.charts = raw;
    solve.formulations = {"r-epsilon"};
    const auto found = test::solve_scene<double>(scene, solve);
    solve.formulations = {"r-omega"};
    const auto truth = test::solve_scene<Quad>(scene, solve, false);
    const auto& exact = truth.formulations[0].solution;
    const PhysicalSolution<Quad> printed = in_quad(found.formulations[0].solution);
    EXPECT_GE(found.formulations[0].estimate.lambda,
              compare_lambda(truth.rows, printed.lambda, exact.lambda).error())
        << seed;
    EXPECT_GE(found.formulations[0].estimate.acceleration,
              compare_accelerations(truth.rows, printed, exact).all.error())
        << seed;
  }
}

TEST(RedundantRows, EstimateCoversWhatTheChoiceOfThemDecides) {
  // hinge coordinates are rounded to double: in quad the rows of the later hinge are not exactly dependent
  const auto door = [](bool reversed) {
    scenes::Scene scene;
    scene.bodies = {test::body("door", 10, {3, 2, 2.5}, {0.5, 0.1, 0.3})};
    scene.bodies[0].orientation = scenes::EulerParameters{{0.9, 0.1, 0.3, 0.2}};
    const Matrix3<double> A = rotation_matrix<double>(Vector4<double>(0.9, 0.1, 0.3, 0.2).normalized());
    const Vector3<double> axis(0.48, 0.6, 0.64);
    for (const double at : {0.1, 0.7}) {
      const Vector3<double> global = at * axis,
                            local = A.transpose() * (global - Vector3<double>(0.5, 0.1, 0.3)),
                            local_axis = A.transpose() * axis;
      const auto v = [](const Vector3<double>& x) { return scenes::Vector3{x[0], x[1], x[2]}; };
      scene.constraints.push_back(test::joint(JointType::revolute, at < 0.5 ? "low" : "high",
                                              test::side(scenes::ground, v(global), v(axis)),
                                              test::side(0, v(local), v(local_axis))));
    }
    if (reversed) std::swap(scene.constraints[0], scene.constraints[1]);
    scene.effects = {test::gravity()};
    return scene;
  };
  const auto one = test::solve_scene<Quad>(door(false)), other = test::solve_scene<Quad>(door(true));
  ASSERT_EQ(one.rows.rank, 5);
  for (std::size_t f = 0; f < one.formulations.size(); ++f) {
    ASSERT_EQ(one.formulations[f].error + other.formulations[f].error, "");
    const double apart =
        acceleration_distance(one.rows, one.formulations[f].solution, other.formulations[f].solution).all;
    EXPECT_GE(apart, 1e-20) << "the choice matters";
    EXPECT_LE(apart, one.formulations[f].estimate.acceleration) << one.formulations[f].name;
    EXPECT_LE(one.formulations[f].estimate.acceleration, 1000 * apart) << one.formulations[f].name;
  }
}

INSTANTIATE_TEST_SUITE_P(Hardships, ErrorEstimate, testing::Range(0, static_cast<int>(std::size(hardships))));

}  // namespace
}  // namespace trivium
