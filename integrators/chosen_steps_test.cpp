/// Chosen steps of methods without an error estimate of their own, on the spherical pendulum.

#include "integrators/chosen_steps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "integrators/contract/spherical_pendulum.hpp"
#include "integrators/integrate.hpp"
#include "integrators/methods.hpp"

namespace trivium::integrators {
namespace {

/// A pendulum that hardly moves near its highest point, and passes the lowest one fast.
SphericalPendulum<double> from_the_top() {
  SphericalPendulum<double> pendulum;
  pendulum.r0 = {std::sin(0.02), 0, std::cos(0.02)};
  pendulum.v0 = {0, 0.01, 0};
  return pendulum;
}

double energy(const SphericalPendulum<double>& pendulum, const StateVector<double>& y) {
  return pendulum.m * (y.tail(3).squaredNorm() / 2 + pendulum.g * y[2]);
}

struct Walked {
  std::vector<double> t, step_ends;
  std::vector<StateVector<double>> y;
  std::vector<double> lambda;
  Counters counters;
};

template <class Model>
Walked run(Model&& pendulum, const std::string& name, double end, std::optional<double> output_step,
           double tolerance, const MethodParameters& parameters = {}) {
  SystemAdapter<Model> system(pendulum);
  const auto method = make_method<double>(name, Steps::chosen, {tolerance, tolerance}, parameters);
  ProjectionReport<double> report;
  Walked walked;
  integrate<double>(
      system, *method, TimeGrid(0, end, output_step), !find_method(name)->meets_constraints, report,
      [&](const double& t, const StateVector<double>&) {
        walked.step_ends.push_back(t);
        return Continue::yes;
      },
      [&](const double& t, const StateVector<double>& y) {
        walked.t.push_back(t);
        walked.y.push_back(y);
        walked.lambda.push_back(method->lambda() ? (*method->lambda())[0] : 0);
        return Continue::yes;
      });
  walked.counters = method->counters();
  return walked;
}

class ErrorControlled : public testing::TestWithParam<std::pair<const char*, int>> {};

TEST_P(ErrorControlled, TakesStepsThatGrowWithTheToleranceAsTheOrderSays) {
  const std::string name = GetParam().first;
  const int order = GetParam().second;
  const auto steps = [&](double tolerance) {
    return static_cast<double>(run(SphericalPendulum<double>(), name, 2, {}, tolerance).counters.steps);
  };
  const double expected = std::pow(1e3, 1.0 / (order + 1)), found = steps(1e-8) / steps(1e-5);
  EXPECT_GT(found, 0.7 * expected);
  EXPECT_LT(found, 1.5 * expected);
}

TEST_P(ErrorControlled, RejectsFewSteps) {
  const Counters counters = run(from_the_top(), GetParam().first, 20, {}, 1e-6).counters;
  EXPECT_LE(counters.rejected_steps, counters.steps / 10);
}

TEST_P(ErrorControlled, StaysNearTheExactMotion) {
  const StateVector<double> exact = run(SphericalPendulum<double>(), "rkf78", 2, {}, 1e-13).y.back();
  for (const double tolerance : {1e-4, 1e-7}) {
    const Walked walked = run(SphericalPendulum<double>(), GetParam().first, 2, {}, tolerance);
    // the errors of all steps add up, and the motion enlarges them
    EXPECT_LE((walked.y.back() - exact).norm(), 10 * tolerance * static_cast<double>(walked.counters.steps))
        << tolerance;
  }
}

TEST(ErrorControl, TakesAboutAsManyStepsWithIndex3AsWithStabilisedIndex2) {
  const auto steps = [](const char* name) {
    return static_cast<double>(run(from_the_top(), name, 20, {}, 1e-4).counters.steps);
  };
  const double stabilised = steps("generalized-alpha-gl2");
  EXPECT_LE(steps("generalized-alpha"), 1.2 * stabilised);
  EXPECT_LE(steps("hht"), 1.2 * stabilised);
}

TEST(ErrorControl, TakesFewStepsWithIndex3ForEveryDampingThatIsAccepted) {
  const auto steps = [](const char* name, const MethodParameters& parameters) {
    return static_cast<double>(run(from_the_top(), name, 20, {}, 1e-4, parameters).counters.steps);
  };
  const double with_default = steps("generalized-alpha", {});
  for (const double rho : {0.0, 0.5, 0.95})
    EXPECT_LE(steps("generalized-alpha", {.rho = rho}), 2 * with_default) << rho;
  for (const double alpha : {-1.0 / 3, -0.05})
    EXPECT_LE(steps("hht", {.alpha = alpha}), 2 * with_default) << alpha;
  EXPECT_THROW(steps("generalized-alpha", {.rho = 1.0}), UsageError);
  EXPECT_THROW(steps("hht", {.alpha = 0.0}), UsageError);
}

class BdfOfOrder : public testing::TestWithParam<int> {};

TEST_P(BdfOfOrder, ShowsItsRawLambdaAndBeginsOnce) {
  const Walked walked = run(SphericalPendulum<double>(), "bdf", 2, 0.5, 1e-4, {.order = GetParam()});
  SphericalPendulum<double> pendulum;
  StateVector<double> v_dot, lambda;
  for (std::size_t k = 1; k < walked.t.size(); ++k) {
    pendulum.accelerations(0, walked.y[k], v_dot, lambda);
    EXPECT_NE(walked.lambda[k], 0);
    EXPECT_NEAR(walked.lambda[k], lambda[0], 0.1 * std::abs(lambda[0]));
  }
  EXPECT_LE(walked.counters.right_sides, 10 * walked.counters.steps);
}

INSTANTIATE_TEST_SUITE_P(Orders, BdfOfOrder, testing::Values(1, 2, 3, 4, 5));

INSTANTIATE_TEST_SUITE_P(Methods, ErrorControlled,
                         testing::Values(std::pair("generalized-alpha", 2),
                                         std::pair("generalized-alpha-gl2", 2), std::pair("hht", 2),
                                         std::pair("bdf", 2), std::pair("hem4", 4)),
                         [](const auto& method) {
                           std::string name = method.param.first;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(ReversibleSteps, KeepTheEnergyErrorBounded) {
  const auto pendulum = from_the_top();
  const Walked walked = run(from_the_top(), "rattle", 100, 0.1, 1e-5);
  const double at_start = energy(pendulum, walked.y.front());
  const auto largest = [&](double from, double to) {
    double error = 0;
    for (std::size_t k = 0; k < walked.t.size(); ++k)
      if (walked.t[k] >= from && walked.t[k] <= to)
        error = std::max(error, std::abs(energy(pendulum, walked.y[k]) - at_start));
    return error;
  };
  const double early = largest(0, 20);
  EXPECT_GT(early, 1e-6);
  EXPECT_LE(largest(80, 100), 1.5 * early);
}

TEST(ReversibleSteps, AreShortWhereTheMotionIsFast) {
  const Walked walked = run(from_the_top(), "rattle", 20, {}, 1e-5);
  double shortest = 1, longest = 0;
  for (std::size_t k = 1; k + 1 < walked.step_ends.size(); ++k) {
    const double h = walked.step_ends[k] - walked.step_ends[k - 1];
    shortest = std::min(shortest, h);
    longest = std::max(longest, h);
  }
  EXPECT_GT(longest, 3 * shortest);
}

TEST(ReversibleSteps, DoNotDependOnOutputs) {
  const Walked with = run(from_the_top(), "rattle", 20, 0.002, 1e-4),
               without = run(from_the_top(), "rattle", 20, {}, 1e-4);
  EXPECT_EQ(with.step_ends, without.step_ends);
  EXPECT_EQ(with.y.back(), without.y.back());
  EXPECT_EQ(with.lambda.back(), without.lambda.back());
}

/// Keeps the times at which it was asked for accelerations; beyond `wall` there are none.
struct Watched : SphericalPendulum<double> {
  double wall = 1e9;
  double *earliest, *latest;

  Watched(double& from, double& to) : earliest(&from), latest(&to) {}
  void accelerations(double t, const Y& y, Y& v_dot, Y& lambda) const {
    *earliest = std::min(*earliest, t);
    *latest = std::max(*latest, t);
    if (t > wall) throw std::runtime_error("the wall");
    SphericalPendulum<double>::accelerations(t, y, v_dot, lambda);
  }
};

TEST(ReversibleSteps, AskForNothingBeforeTheStartOrBeyondTheEnd) {
  double earliest = 0, latest = 0;
  run(Watched(earliest, latest), "rattle", 2, {}, 1e-4);
  EXPECT_EQ(earliest, 0);
  EXPECT_EQ(latest, 2);
}

TEST(ReversibleSteps, EndTheRunWhereNoStepCanBeTaken) {
  double earliest = 0, latest = 0;
  Watched pendulum(earliest, latest);
  pendulum.wall = 1;
  EXPECT_THROW(run(std::move(pendulum), "rattle", 2, {}, 1e-4), IntegrationError);
}

TEST(ReversibleSteps, GiveMultipliersBetweenThoseOfTheEndsOfTheStepAtOutputs) {
  const Walked walked = run(from_the_top(), "rattle", 20, 1e-3, 1e-3);
  SphericalPendulum<double> pendulum;
  StateVector<double> v_dot, lambda;
  for (std::size_t k = 1; k < walked.t.size(); ++k) {
    pendulum.accelerations(0, walked.y[k], v_dot, lambda);
    EXPECT_NEAR(walked.lambda[k], lambda[0], 1) << walked.t[k];
  }
}

TEST(ReversibleSteps, SatisfyTheConstraintsAtOutputsWithinAStep) {
  SphericalPendulum<double> pendulum;
  const Walked walked = run(SphericalPendulum<double>(), "rattle", 2, 0.004, 1e-4);
  EXPECT_GT(walked.t.size(), walked.step_ends.size());
  for (std::size_t k = 1; k < walked.t.size(); ++k) {
    EXPECT_LE(pendulum.position_violation(0, walked.y[k]).size, 1e-13);
    EXPECT_LE(pendulum.velocity_violation(0, walked.y[k]).size, 1e-12);
    StateVector<double> v_dot, lambda;
    pendulum.accelerations(0, walked.y[k], v_dot, lambda);
    EXPECT_NEAR(walked.lambda[k], lambda[0], 0.02 * std::abs(lambda[0])) << walked.t[k];
  }
}

}  // namespace
}  // namespace trivium::integrators
