/// The estimate of local errors against the errors of single steps.

#include "simulation/system/local_error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "formulations/formulation_list.hpp"
#include "integrators/methods.hpp"
#include "mechanism/reach.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/testing/catalogue_scene.hpp"
#include "scenes/testing/scene_builders.hpp"
#include "simulation/neighbouring_start.hpp"
#include "simulation/simulate.hpp"

namespace trivium {
namespace {

/// A body that moves by given functions of time: A = R_x(t^2) R_y(sin t).
BodyInMotion<double> turning(double t) {
  BodyInMotion<double> body;
  body.r = {std::sin(t), std::cos(2 * t), t * t * t};
  body.v = {std::cos(t), -2 * std::sin(2 * t), 3 * t * t};
  body.a = {-std::sin(t), -4 * std::cos(2 * t), 6 * t};
  const double beta = std::sin(t), c = std::cos(beta), s = std::sin(beta), beta_dot = std::cos(t);
  body.p = multiply_parameters<double>(exponential_parameters<double>({t * t, 0, 0}),
                                       exponential_parameters<double>({0, beta, 0}));
  body.omega_bar = {2 * t * c, beta_dot, 2 * t * s};
  body.omega_bar_dot = {2 * c - 2 * t * beta_dot * s, -std::sin(t), 2 * s + 2 * t * beta_dot * c};
  return body;
}

const std::vector<std::vector<int>> of_several_kinds{
    {3, 3}, {3, 2, 3}, {2, 2, 2}, {2, 2, 2, 2, 2}, {1, 2, 3}};

TEST(StepFormula, HoldsForPolynomialsUpToItsDegree) {
  for (const std::vector<int>& n : of_several_kinds) {
    const auto formula = StepFormula<double>::even(n);
    const auto remainder = [&](int degree) {  // of t^degree, h = 1
      double sum = 0;
      for (int j = 0; j < formula.times(); ++j) {
        const auto power = [&](int m) { return m < 0 ? 0.0 : std::pow(j, m); };
        sum += formula.of_x[j] * power(degree) + formula.of_rate[j] * degree * power(degree - 1) +
               formula.of_second[j] * degree * (degree - 1) * power(degree - 2);
      }
      return std::abs(sum) / std::pow(formula.times(), degree);
    };
    const int first_not_exact = std::accumulate(n.begin(), n.end(), -1);
    for (int degree = 0; degree < first_not_exact; ++degree) EXPECT_LE(remainder(degree), 1e-14);
    EXPECT_GE(remainder(first_not_exact), 1e-6);
  }
}

TEST(StepFormula, LeavesTheErrorThatEveryStepCommits) {
  for (const std::vector<int>& n : of_several_kinds) {
    const auto formula = StepFormula<double>::even(n);
    double sum = 0;
    for (int j = 0; j < formula.times(); ++j) sum += formula.of_x[j] * (7 + 0.3 * j);  // 0.3 more in a step
    EXPECT_NEAR(sum, 0.3, 1e-13);
  }
}

/// The state n, at the end of a step of length h.
void give(LocalError<double>& local, int n, std::vector<BodyInMotion<double>> bodies, double h) {
  if (n == 0)
    local.begin(bodies);
  else
    local.add(bodies, h, true);
}

LocalErrorSums sums_of(LocalError<double>& local, std::size_t bodies = 1) {
  return local.sums(std::vector<double>(bodies, 1));
}

TEST(LocalError, OfAnExactMotionFallsWithThePowerOfItsFormula) {
  for (const auto& [order, power] : {std::pair{1, 5}, {2, 5}, {4, 7}, {5, 7}}) {
    const auto sums_with = [&](double h) {
      LocalError<double> local(order, {1.0}, {0});
      for (int n = 0; n <= 6; ++n) give(local, n, {turning(n * h)}, h);
      EXPECT_GE(sums_of(local).steps, 1);
      return sums_of(local).position / 6;
    };
    EXPECT_GE(std::log2(sums_with(0.04) / sums_with(0.02)), power - 0.4) << order;
  }
}

// 10 rad in a step; the error of any interpolation would be as large as the angle
TEST(LocalError, OfAnEvenSpinIsRounding) {
  for (const int order : {2, 5}) {
    LocalError<double> local(order, {1.0}, {0});
    for (int n = 0; n <= 8; ++n) {
      BodyInMotion<double> body;
      body.r = body.v = body.a = body.omega_bar_dot = Vector3<double>::Zero();
      body.omega_bar = {30, 80, -50};
      body.p = exponential_parameters(Vector3<double>(0.1 * n * body.omega_bar));
      give(local, n, {body}, 0.1);
    }
    EXPECT_LE(sums_of(local).position, 1e-12) << order;
  }
}

// after three states, three are left out
TEST(LocalError, CountsStepsThatAreNotEstimatedLikeTheOthers) {
  LocalError<double> local(2, {0.3, 0.3}, {1, 1});
  BodyInMotion<double> still{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  for (int n = 0; n <= 9; ++n) {
    if (local.leaves_out()) continue;
    BodyInMotion<double> drifting = still;
    drifting.r = {0, 0, 0.5 + 0.01 * n};  // without a velocity: 0.01 m of error in each step
    give(local, n, {still, drifting}, 0.1);
  }
  const LocalErrorSums sums = sums_of(local, 2);
  EXPECT_EQ(sums.steps, 2);
  EXPECT_EQ(sums.body, 1);
  EXPECT_NEAR(sums.position, 0.09, 1e-14);
  EXPECT_NEAR(sums.size, 0.58 + 0.3, 1e-14);  // from where body 0 began
}

TEST(LocalError, IsComparedWithTheSizeOfConnectedBodiesAlone) {
  LocalError<double> local(2, {0.3, 100}, {0, 1});
  for (int n = 0; n <= 6; ++n) {
    std::vector<BodyInMotion<double>> bodies(2);
    for (auto& body : bodies) {
      body = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
      body.r.x() = 500 + 0.01 * n;
    }
    give(local, n, std::move(bodies), 0.1);
  }
  const LocalErrorSums sums = sums_of(local, 2);
  EXPECT_EQ(sums.body, 0);
  EXPECT_NEAR(sums.size, 0.06 + 0.3, 1e-12);
}

// Steps that are not estimated enter with the mean: here all are.
TEST(LocalError, OfStepsOfDifferentLengthsIsTheirSum) {
  const auto sums = [](int order, const std::vector<double>& steps) {
    LocalError<double> local(order, {1.0}, {0});
    BodyInMotion<double> body{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    give(local, 0, {body}, 0);
    for (const double h : steps) {
      body.r.x() += std::pow(h, order + 1);  // the error of a step
      give(local, 1, {body}, h);
    }
    return std::pair(sums_of(local), body.r.x());
  };
  for (const auto& [order, steps] : {std::pair<int, std::vector<double>>{2, {0.1}},
                                     {2, {0.1, 0.2}},
                                     {2, {0.2, 0.01}},
                                     {5, {0.1, 0.2}},
                                     {5, {0.1, 0.1, 0.05, 0.1}},
                                     {5, {0.1, 0.01, 0.1, 0.01}}}) {
    const auto [estimated, error] = sums(order, steps);
    EXPECT_EQ(estimated.unknown, 0);
    EXPECT_NEAR(estimated.position, error, 1e-14);
  }
  EXPECT_EQ(sums(5, {0.1}).first.unknown, 1);
  EXPECT_EQ(sums(5, {0.2, 0.01}).first.unknown, 1);  // states that are too near to each other for a formula
}

// A push of 3 ms, in two parts of `steps` steps each, between events; everywhere else nothing errs.
TEST(LocalErrors, OfFewStepsBetweenEventsAreKnown) {
  for (const int steps : {2, 3, 4})
    for (const char* method : {"dopri5", "arkode-erk", "hem4", "radau5"}) {
      const double h = 1e-3, middle = 0.51, rise = steps * h;
      scenes::Scene scene;
      scene.bodies = {test::body("puck", 1, {1, 1, 1}, {0, 0, 0})};
      Force<double> force;
      force.components = {
          TimeFunction(TimeFunction::Sum{{TimeFunction::Step5{middle - rise, 0, middle, 1 / rise},
                                          TimeFunction::Step5{middle, 0, middle + rise, -1 / rise}}}),
          TimeFunction(0), TimeFunction(0)};
      scene.effects = {force};
      SimulationOptions options;
      options.integrator = method;
      options.step = h;
      options.end = 1;
      Samples samples;
      const SimulationReport report = simulate(make_model<double>(scene), options, samples);
      const double error = std::abs(report.end.state.twist[0].r_dot.x() - 1);
      EXPECT_GE(5 * report.local_errors->velocity, error) << method << ", " << steps;
    }
}

// A slider on a spring at rest, and then under a force that jumps every few steps, beside the grid.
TEST(LocalErrors, OfAMotionInPartsAreThoseOfItsParts) {
  const double h = 0.005, omega = 20;
  for (const int steps : {2, 3, 4, 6, 8}) {
    scenes::Scene scene;
    scene.bodies = {test::body("slider", 1, {1, 1, 1}, {0, 0, 0})};
    SpringDamper<double> spring;
    spring.i.body = scenes::ground;
    spring.i.s_bar = {-10, 0, 0};
    spring.j.body = 0;
    spring.stiffness = omega * omega;
    spring.free_length = 10;
    TimeFunction::Piecewise jumps{{}, {TimeFunction(0)}};
    for (double t = 2 + 0.3 * h; t < 3.9; t += steps * h) {
      jumps.times.push_back(t);
      jumps.pieces.push_back(TimeFunction(omega * omega * std::sin(7 * t)));
    }
    Force<double> force;
    force.components = {TimeFunction(jumps), TimeFunction(0), TimeFunction(0)};
    scene.effects = {spring, force};
    const Model<double> model = make_model<double>(scene);
    SimulationOptions options;
    options.end = 3.995;
    options.integrator = "rkf78";
    options.tolerances = {1e-12, 1e-12};
    Samples samples;
    const Twist<double> exact = simulate(model, options, samples).end.state.twist[0];
    options.step = h;
    for (const char* method :
         {"generalized-alpha", "hht", "rattle", "rattle4", "hem4", "dopri5", "abm", "radau5"}) {
      options.integrator = method;
      const SimulationReport report = simulate(model, options, samples);
      const double error = (report.end.state.twist[0].r_dot - exact.r_dot).norm();
      EXPECT_GE(10 * report.local_errors->velocity, error) << method << ", " << steps;
    }
  }
}

TEST(HalvedSteps, LeaveTheMotionAsItIs) {
  for (const char* name : {"heavy_top", "four_bar", "spatial_slider_crank", "driven_crank"})
    for (const char* method : {"rkf78", "radau9"})
      for (const auto& formulation : formulation_names()) {
        SimulationOptions options;
        options.formulation = formulation;
        options.integrator = method;
        options.step = 2e-3;
        options.end = 0.4;
        const Model<double> model = make_model<double>(test::catalogue_scene(name));
        Samples watched, alone;
        simulate(model, options, watched);
        options.watches = false;
        simulate(model, options, alone);
        for (std::size_t b = 0; b < model.state.pose.size(); ++b) {
          EXPECT_EQ(watched.all.back().state.pose[b].r, alone.all.back().state.pose[b].r);
          EXPECT_EQ(watched.all.back().state.pose[b].p, alone.all.back().state.pose[b].p);
          EXPECT_EQ(watched.all.back().state.twist[b].r_dot, alone.all.back().state.twist[b].r_dot)
              << name << ", " << method << ", " << formulation;
        }
      }
}

// The first errors are rounding, which says nothing about those of later steps.
TEST(HalvedSteps, DoNotTakeRoundingForAnErrorThatGrows) {
  scenes::Scene scene;
  scene.bodies = {test::body("bob", 1, {0.1, 0.2, 0.25}, {0, 0, -1})};
  scene.constraints = {test::joint(JointType::spherical, "pivot", test::side(scenes::ground),
                                   test::side(0, scenes::Vector3{0, 0, 1}))};
  Torque<double> torque;
  torque.components = {TimeFunction::Polynomial{{0, 0, 0, 0, 1}}, TimeFunction(0),
                       TimeFunction::Polynomial{{0, 0, 0, 0, 0, 2}}};
  scene.effects = {test::gravity(), torque};
  for (const char* method : {"rkf78", "radau9"})
    for (const char* formulation : {"r-omega", "r-p", "r-epsilon"}) {
      SimulationOptions options;
      options.formulation = formulation;
      options.integrator = method;
      options.step = 0.005;
      options.end = 2;
      Samples samples;
      const LocalErrorSums sums = *simulate(make_model<double>(scene), options, samples).local_errors;
      EXPECT_LE(sums.position, 1e-7) << method << ", " << formulation;
      EXPECT_LE(sums.velocity, 1e-5) << method << ", " << formulation;
    }
}

/// The sum over the steps of the errors of one body, of positions [m] and of velocities [m/s], without the
/// steps before `first`. Each step is taken from the method's own state by a method of high order. Nothing if
/// no exact motion starts there: index 3 leaves velocities off redundant rows.
std::optional<LocalErrorSums> errors_of_single_steps(const Model<double>& model, const Samples& samples,
                                                     int b, std::size_t first) {
  const double reach = reaches(model.mechanism)[b];
  LocalErrorSums sums;
  for (std::size_t n = first; n + 1 < samples.all.size(); ++n) {
    SimulationOptions exactly;
    exactly.integrator = "rkf78";
    exactly.tolerances = {1e-13, 1e-15};
    exactly.end = samples.all[n + 1].state.t;
    Samples one;
    try {
      simulate(Model<double>{model.mechanism, samples.all[n].state}, exactly, one);
    } catch (const Error&) {
      return {};
    }
    const MechanismState<double>&exact = one.all.back().state, &state = samples.all[n + 1].state;
    sums.position +=
        (exact.pose[b].r - state.pose[b].r).norm() + reach * turn_between(exact.pose[b].p, state.pose[b].p);
    sums.velocity += (exact.twist[b].r_dot - state.twist[b].r_dot).norm() +
                     reach * (exact.twist[b].omega_bar - state.twist[b].omega_bar).norm();
  }
  return sums;
}

struct Estimated {
  const char* method;
  bool meets_velocities;  ///< else velocities miss their rows, which the estimate leaves out
  double longest_step;    ///< [s]; each of the others is half of the one before
};
const std::vector<Estimated> estimated_methods{{"generalized-alpha", false, 4e-3},
                                               {"generalized-alpha-gl2", true, 4e-3},
                                               {"hht", false, 4e-3},
                                               {"bdf", false, 4e-3},
                                               {"rattle", true, 4e-3},
                                               {"rattle4", true, 4e-3},
                                               {"hem4", true, 4e-3},
                                               {"dopri5", true, 1.6e-2},
                                               {"hedop5", true, 1.6e-2},
                                               {"abm", true, 8e-3},
                                               {"radau5", true, 1.6e-2},
                                               {"rkf78", true, 3.2e-2},
                                               {"radau9", true, 6.4e-2}};

constexpr std::size_t not_estimated = 4;  // steps, by the formula for order 5
// velocities are compared where the method meets their rows
class LocalErrors : public ::testing::TestWithParam<std::tuple<Estimated, const char*>> {};
TEST_P(LocalErrors, AreThoseOfSingleStepsWithinAFactorFive) {
  const auto& [estimated_method, formulation] = GetParam();
  const integrators::MethodInfo& method = *integrators::find_method(estimated_method.method);
  if (!goes_with(method, formulation)) GTEST_SKIP();
  const bool needs_halved_steps = method.standard_order > LocalError<double>::highest_order;
  std::vector<double> of_positions, of_velocities;
  for (const auto& file : catalogue())
    for (const double halved : {1, 2, 4, 8}) {
      const double h = estimated_method.longest_step / halved;
      const std::string name = file.stem().string();
      if (name == "n_four_bar_40") continue;  // slow, and of the kind of n_four_bar_2
      // the motion shows nothing of a singular position, where these methods err far more than elsewhere
      if (needs_halved_steps && name.starts_with("n_four_bar")) continue;
      const Model<double> model = make_model<double>(test::catalogue_scene(name));
      SimulationOptions options;
      options.formulation = formulation;
      options.integrator = estimated_method.method;
      options.step = options.output_step = h;
      options.end = 80 * h;
      Samples samples;
      SimulationReport report;
      try {
        report = simulate(model, options, samples);
      } catch (const Error&) {  // a driver at a dead point, or a singular position
        continue;
      }
      ASSERT_TRUE(report.local_errors);
      if (report.reframings > 0) continue;  // the steps before and after are estimated less well
      const LocalErrorSums& estimated = *report.local_errors;
      const auto sums = errors_of_single_steps(model, samples, estimated.body, not_estimated);
      if (!sums) continue;
      // below, errors are rounding
      if (sums->position > 1e-12 * std::max(1.0, estimated.size)) {
        of_positions.push_back(estimated.position / sums->position);
        EXPECT_GE(of_positions.back(), 0.2) << name << ", " << h;
      }
      if (estimated_method.meets_velocities && sums->velocity > 1e-11) {
        of_velocities.push_back(estimated.velocity / sums->velocity);
        EXPECT_GE(of_velocities.back(), 0.2) << name << ", " << h;
      }
    }
  const auto median = [](std::vector<double>& of) {
    std::sort(of.begin(), of.end());
    return of.empty() ? 1 : of[of.size() / 2];
  };
  EXPECT_LE(median(of_positions), 5);
  EXPECT_LE(median(of_velocities), 5);
}
INSTANTIATE_TEST_SUITE_P(Methods, LocalErrors,
                         ::testing::Combine(::testing::ValuesIn(estimated_methods),
                                            ::testing::Values("r-omega", "r-p", "r-epsilon")),
                         [](const auto& all) {
                           std::string name =
                               fmt::format("{}_in_{}", std::get<0>(all.param).method, std::get<1>(all.param));
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace trivium
