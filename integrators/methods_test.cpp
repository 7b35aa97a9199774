/// Methods that need no constrained system, on one-page models: order, tolerances, restarts, events,
/// projection.

#include "integrators/methods.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <string>

#include "integrators/integrate.hpp"
#include "integrators/testing/toy_systems.hpp"

namespace trivium::integrators {
namespace {

using test::Free;
using test::OnACircle;

struct Walked {
  std::vector<double> t;
  std::vector<StateVector<double>> y;
  Counters counters;
  ProjectionReport<double> projection;
};

template <class System>
void run(System& system, const std::string& name, Steps steps, const TimeGrid& grid, Tolerances tolerances,
         bool projects, Walked& out) {
  SystemAdapter<System> erased(system);
  const auto method = make_method<double>(name, steps, tolerances);
  integrate<double>(
      erased, *method, grid, projects, out.projection,
      [](double, const StateVector<double>&) { return Continue::yes; },
      [&](double t, const StateVector<double>& y) {
        out.t.push_back(t);
        out.y.push_back(y);
        return Continue::yes;
      });
  out.counters = method->counters();
}
template <class System>
Walked run(System& system, const std::string& name, Steps steps, const TimeGrid& grid,
           Tolerances tolerances = {}, bool projects = true) {
  Walked out;
  run(system, name, steps, grid, tolerances, projects, out);
  return out;
}

/// x'' = -x + exp(-t) x x': no method solves it exactly.
Free oscillator() {
  Free system;
  system.y0 = Eigen::Vector2d(1, 0);
  system.f = [](double t, const StateVector<double>& y) {
    return StateVector<double>(Eigen::Vector2d(y[1], -y[0] + std::exp(-t) * y[0] * y[1]));
  };
  return system;
}

/// y' = y^2 with the solution y = 1 / (1 - t).
Free ends_at_1() {
  Free system;
  system.y0 = StateVector<double>::Ones(1);
  system.f = [](double, const StateVector<double>& y) { return StateVector<double>(y.cwiseAbs2()); };
  return system;
}

double error_at_end(const std::string& name, double h) {
  static const StateVector<double> exact = [] {
    Free system = oscillator();
    return run(system, "rkf78", Steps::given, TimeGrid(0, 2, {}, 2.0 / 1024)).y.back();
  }();
  Free system = oscillator();
  return (run(system, name, Steps::given, TimeGrid(0, 2, {}, h)).y.back() - exact).norm();
}

/// The methods that need no functions of a ConstrainedSystem, with given or with chosen steps.
std::vector<std::string> explicit_methods(bool MethodInfo::*takes) {
  std::vector<std::string> found;
  const bool is_given = takes == &MethodInfo::takes_given_steps;
  for (const MethodInfo& method : methods()) {
    if (!(method.*takes)) continue;
    Free system = oscillator();
    try {
      run(system, std::string(method.name), is_given ? Steps::given : Steps::chosen,
          is_given ? TimeGrid(0, 0.1, {}, 0.1) : TimeGrid(0, 0.1));
      found.emplace_back(method.name);
    } catch (const UsageError&) {
    }
  }
  return found;
}

const auto in_a_name = [](const auto& method) {
  std::string name = method.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
};

class GivenStepsOf : public testing::TestWithParam<std::string> {};

TEST_P(GivenStepsOf, HaveThePublishedOrder) {
  const MethodInfo& method = *find_method(GetParam());
  const double h = method.order > 6 ? 2.0 / 4 : 2.0 / 32;  // errors are above rounding at h and h / 4
  const double order = std::log2(error_at_end(GetParam(), h) / error_at_end(GetParam(), h / 4)) / 2;
  EXPECT_NEAR(order, method.order, 0.2);
}

TEST_P(GivenStepsOf, AreAnErrorIfTheModelNeedsShorterOnes) {
  Free system = oscillator();
  system.longest = 0.01;
  EXPECT_THROW(run(system, GetParam(), Steps::given, TimeGrid(0, 1, {}, 0.02)), IntegrationError);
  EXPECT_EQ(run(system, GetParam(), Steps::given, TimeGrid(0, 1, {}, 0.01)).counters.steps, 100);
}

INSTANTIATE_TEST_SUITE_P(Methods, GivenStepsOf,
                         testing::ValuesIn(explicit_methods(&MethodInfo::takes_given_steps)), in_a_name);

class ChosenStepsOf : public testing::TestWithParam<std::string> {};

TEST_P(ChosenStepsOf, FollowTheTolerance) {
  for (const double rtol : {1e-4, 1e-7, 1e-10}) {
    OnACircle system;
    const Walked r = run(system, GetParam(), Steps::chosen, TimeGrid(0, 6, 1.5), {rtol, rtol});
    ASSERT_EQ(r.t.size(), 5u);
    for (std::size_t k = 0; k < r.t.size(); ++k) {
      EXPECT_EQ(r.t[k], 1.5 * static_cast<double>(k));
      const StateVector<double> exact =
          Eigen::Vector4d(std::cos(r.t[k]), std::sin(r.t[k]), -std::sin(r.t[k]), std::cos(r.t[k]));
      // the errors of Adams methods add up over many short steps
      EXPECT_LE((r.y[k] - exact).norm(), (GetParam() == "cvode-adams" ? 1000 : 200) * rtol) << r.t[k];
    }
    EXPECT_LE(system.position_violation(0, r.y.back()).size, 4e-15);  // rounding that a projection leaves
  }
}

TEST_P(ChosenStepsOf, GiveUpWhereTheMotionEndsAndSayWhen) {
  Free system = ends_at_1();
  try {
    run(system, GetParam(), Steps::chosen, TimeGrid(0, 2));
    FAIL();
  } catch (const IntegrationError& error) {
    EXPECT_NE(std::string(error.what()).find("t = "), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("step"), std::string::npos) << error.what();
  }
}

TEST_P(ChosenStepsOf, ShowTheStateThatAFailedRunHasReached) {
  Free system = ends_at_1();
  Walked out;
  EXPECT_THROW(run(system, GetParam(), Steps::chosen, TimeGrid(0, 2), {}, true, out), IntegrationError);
  ASSERT_EQ(out.t.size(), 2u);  // the start, and the last state
  EXPECT_GT(out.t.back(), 0.99);
  EXPECT_GT(out.y.back()[0], 100);
}

TEST_P(ChosenStepsOf, TakeASmallerStepWhereARightSideCannotBeEvaluated) {
  Free system;  // solution y = 0.2 + (sqrt(0.8) - t / 2)^2
  system.y0 = StateVector<double>::Ones(1);
  system.f = [](double, const StateVector<double>& y) {
    if (y[0] < 0.2) throw std::runtime_error("the root of a negative number");
    return StateVector<double>(-(y.array() - 0.2).sqrt().matrix());
  };
  const Walked r = run(system, GetParam(), Steps::chosen, TimeGrid(0, 1.5), {1e-3, 1e-3});
  EXPECT_NEAR(r.y.back()[0], 0.2 + std::pow(std::sqrt(0.8) - 0.75, 2), 0.02);
}

TEST_P(ChosenStepsOf, StartAnewWhereCoordinatesChange) {
  Free system = oscillator();
  system.changes_at = 5;
  EXPECT_EQ(run(system, GetParam(), Steps::chosen, TimeGrid(0, 2)).counters.restarts, 1);
}

TEST_P(ChosenStepsOf, AreNoLongerThanTheModelSays) {
  Free system = oscillator();
  system.longest = 0.01;
  const Walked r = run(system, GetParam(), Steps::chosen, TimeGrid(0, 2), {1e-3, 1e-3});
  EXPECT_GE(r.counters.steps, 200);
  EXPECT_EQ(r.t.back(), 2);
}

TEST_P(ChosenStepsOf, SeeErrorsWhereAnAngleOfConstantRateDecidesAll) {
  constexpr double rate = 3, end = 20;
  Free system;  // angle, x and x'; x = sin(angle)
  system.y0 = Eigen::Vector3d(0, 0, rate);
  system.f = [=](double, const StateVector<double>& y) {
    return StateVector<double>(Eigen::Vector3d(rate, y[2], -rate * rate * std::sin(y[0])));
  };
  const Walked r = run(system, GetParam(), Steps::chosen, TimeGrid(0, end), {1e-8, 1e-8});
  // errors of x' add up over the whole time
  EXPECT_NEAR(r.y.back()[1], std::sin(rate * end), 1e-4);
}

TEST_P(ChosenStepsOf, KeepTheirOrderAcrossAKink) {
  const auto error = [&](std::vector<double> events) {
    Free system;  // y' = |t - 1 / pi|, a kink at 1 / pi
    system.y0 = StateVector<double>::Zero(1);
    const double kink = 1 / std::acos(-1.0);
    system.f = [=](double t, const StateVector<double>&) {
      return StateVector<double>::Constant(1, std::abs(t - kink));
    };
    const double exact = (kink * kink + (1 - kink) * (1 - kink)) / 2;
    const Walked r =
        run(system, GetParam(), Steps::chosen, TimeGrid(0, 1, {}, {}, std::move(events)), {1e-9, 1e-9});
    return std::pair(std::abs(r.y.back()[0] - exact), r.counters.rejected_steps);
  };
  const auto [without, rejected] = error({});
  const auto [with, rejected_with] = error({1 / std::acos(-1.0)});
  EXPECT_LE(with, GetParam() == "cvode-adams" ? 1e-9 : 1e-14);  // cvode-adams restarts with order 1
  EXPECT_GT(without, 1e-14);
  EXPECT_LE(rejected_with, rejected);
}

INSTANTIATE_TEST_SUITE_P(Methods, ChosenStepsOf,
                         testing::ValuesIn(explicit_methods(&MethodInfo::chooses_steps)), in_a_name);

TEST(Methods, AreFoundByTheirNames) {
  for (const MethodInfo& method : methods()) {
    EXPECT_EQ(find_method(method.name), &method);
    for (const auto& [steps, takes] :
         {std::pair(Steps::chosen, method.chooses_steps), {Steps::given, method.takes_given_steps}})
      if (takes)
        EXPECT_NE(make_method<double>(method.name, steps, {}), nullptr);
      else
        EXPECT_THROW(make_method<double>(method.name, steps, {}), UsageError);
  }
  EXPECT_EQ(find_method("euler"), nullptr);
}

/// Its steps get shorter and shorter.
struct Creeping {
  Counters counted;
  double h = 1e-6;
  void step(AnySystem<double>&, double& t, StateVector<double>&, double stop) {
    t = std::min(t + h, stop);
    h = std::max(h / 2, 1e-14);
    ++counted.steps;
  }
  void restart() {}
  bool shorten() { return false; }
  const Counters& counters() const { return counted; }
};

TEST(Integrate, EndsARunThatNoLongerGetsOn) {
  Free system = oscillator();
  SystemAdapter<Free> erased(system);
  const auto method = adapt<double>(Creeping());
  ProjectionReport<double> projection;
  const auto go_on = [](double, const StateVector<double>&) { return Continue::yes; };
  try {
    integrate<double>(erased, *method, TimeGrid(0, 1), false, projection, go_on, go_on);
    FAIL();
  } catch (const IntegrationError& error) {
    EXPECT_NE(std::string(error.what()).find("does not get on"), std::string::npos) << error.what();
    EXPECT_LE(method->counters().steps, 200000);
  }
}

TEST(Projection, MeetsPositionsAndVelocitiesByOneFactorisation) {
  OnACircle system;
  StateVector<double> y = Eigen::Vector4d(0.6 + 1e-4, 0.8, -0.8, 0.6 + 1e-3);
  ProjectionReport<double> report;
  ProjectionIteration<OnACircle>()(system, 0.0, y, report);
  EXPECT_LE(system.position_violation(0, y).size, 4e-16);
  EXPECT_LE(system.velocity_violation(0, y).size, 4e-16);
  EXPECT_EQ(system.factors, 1);
  EXPECT_NEAR(report.position, 0.6e-4, 1e-6);
  EXPECT_LE(report.position_left, 4e-16);
}

TEST(Projection, NamesTheRowThatItCannotMeet) {
  OnACircle system;
  system.stuck = true;
  StateVector<double> y = Eigen::Vector4d(1.1, 0, 0, 1);
  ProjectionReport<double> report;
  try {
    ProjectionIteration<OnACircle>()(system, 0.25, y, report);
    FAIL();
  } catch (const IntegrationError& error) {
    EXPECT_NE(std::string(error.what()).find("\"circle\" at t = 0.25"), std::string::npos) << error.what();
  }
}

TEST(Projection, IsLeftOutWhereToldSo) {
  OnACircle system;
  const Walked r = run(system, "dopri5", Steps::given, TimeGrid(0, 6, {}, 0.25), {}, false);
  EXPECT_EQ(system.factors, 0);
  EXPECT_GT(system.position_violation(0, r.y.back()).size, 1e-8);
}

TEST(Projection, OfAStepThatIsFarTooLongIsAnErrorAtGivenSteps) {
  OnACircle system(40);
  EXPECT_THROW(run(system, "dopri5", Steps::given, TimeGrid(0, 1, {}, 0.25)), IntegrationError);
  EXPECT_NO_THROW(run(system, "dopri5", Steps::chosen, TimeGrid(0, 1), {1e-2, 1e-2}));
}

/// The line of the table of methods, docs/simulating.md, that begins with this method.
std::string line_of_the_page(const std::string& method) {
  std::ifstream page(TRIVIUM_DOCS_DIR "/simulating.md");
  for (std::string line; std::getline(page, line);)
    if (line.starts_with("| `") &&
        line.substr(0, line.find('|', 1)).find("`" + method + "`") != std::string::npos)
      return line;
  return {};
}

TEST(MethodsPage, SaysTheOrdersAndStepsOfEveryMethod) {
  for (const MethodInfo& method : methods()) {
    const std::string line = line_of_the_page(std::string(method.name));
    const auto says = [&](const std::string& text) { return line.find(text) != std::string::npos; };
    ASSERT_NE(line, "") << method.name;
    EXPECT_EQ(says("chosen"), method.chooses_steps) << line;
    EXPECT_EQ(says("given |") || says("or given"), method.takes_given_steps) << line;
    const std::string orders = line.substr(line.find('|', line.find('|', 1) + 1));
    const auto has_order = [&](const std::string& pattern, int order) {
      return std::regex_search(orders, std::regex(pattern + "\\b" + std::to_string(order) + "\\b"));
    };
    EXPECT_TRUE(method.standard_order == 0 || has_order("", method.standard_order)) << line;
    const bool has_another_order = method.has_raw_lambda && method.raw_lambda_order != method.order &&
                                   method.raw_lambda_order > 0 && !method.takes_order &&
                                   !method.needs_constant_inertia;
    EXPECT_TRUE(!has_another_order || has_order("raw lambda.*", method.raw_lambda_order)) << line;
  }
}

}  // namespace
}  // namespace trivium::integrators
