/// The estimate of local errors against the errors of single steps.

#include "simulation/system/local_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "formulations/r_omega.hpp"
#include "integrators/methods.hpp"
#include "mechanism/reach.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/testing/catalogue_scene.hpp"
#include "simulation/neighbouring_start.hpp"
#include "simulation/simulate.hpp"

namespace trivium {
namespace {

/// A moving body: r and omega_bar are given functions of time; A is integrated in 4000 midpoint steps, far
/// more accurately than the estimate.
BodyInMotion<double> turning(double t) {
  BodyInMotion<double> body;
  body.r = {std::sin(t), std::cos(2 * t), t * t * t};
  body.v = {std::cos(t), -2 * std::sin(2 * t), 3 * t * t};
  body.a = {-std::sin(t), -4 * std::cos(2 * t), 6 * t};
  const auto omega = [](double s) { return Vector3<double>(1 + s, 2 - s * s, 0.5 + 3 * s); };
  body.omega_bar = omega(t);
  body.omega_bar_dot = {1, -2 * t, 3};
  body.A.setIdentity();
  const int parts = 4000;
  for (int k = 0; k < parts; ++k)
    body.A *=
        rotation_matrix(exponential_parameters(Vector3<double>(t / parts * omega((k + 0.5) * t / parts))));
  return body;
}

// the formula of order p + 1 has the error h^(p + 2) in a step
TEST(LocalError, OfAnExactMotionFallsOneOrderFasterThanThatOfTheMethod) {
  for (const int order : {1, 2, 3}) {
    const auto sums_with = [&](double h) {
      LocalError<double> local(order, {1.0});
      for (int n = 0; n <= 6; ++n) {
        std::vector<BodyInMotion<double>> bodies{turning(n * h)};
        local.add(bodies, h);
      }
      EXPECT_EQ(local.sums().steps, 7 - order);
      return local.sums().position / static_cast<double>(local.sums().steps);
    };
    EXPECT_GE(std::log2(sums_with(0.04) / sums_with(0.02)), order + 1.6) << order;
  }
}

TEST(LocalError, ForgetsTheStatesBeforeAStepOfAnotherLength) {
  LocalError<double> local(2, {1.0});
  double t = 0;
  for (const double h : {0.01, 0.01, 0.01, 0.02, 0.02}) {
    std::vector<BodyInMotion<double>> bodies{turning(t += h)};
    local.add(bodies, h);
  }
  EXPECT_EQ(local.sums().steps, 2);
}

/// The error of the points of a body between two states [m].
double points_apart(const MotionSample& a, const MotionSample& b, std::size_t k, double reach) {
  const double turn = turn_between(a.state.pose[k].p, b.state.pose[k].p);
  return (a.state.pose[k].r - b.state.pose[k].r).norm() + reach * turn;
}

// The sum of local errors is compared with the sum of the errors of single steps, each from the method's own
// state, by a method of high order.
TEST(LocalError, IsThatOfSingleStepsWithinAFactorFive) {
  std::vector<double> ratios;
  for (const auto& file : catalogue())
    for (const char* method : {"generalized-alpha", "generalized-alpha-gl2", "hht", "bdf", "rattle"})
      for (const double h : {2e-3, 1e-3, 5e-4}) {
        const std::string name = file.stem().string();
        if (name == "n_four_bar_40") continue;  // slow, and of the kind of n_four_bar_2
        const Model<double> model = make_model<double>(test::catalogue_scene(name));
        const std::vector<double> reach = reaches(model.mechanism);
        SimulationOptions options;
        options.integrator = method;
        options.step = options.output_step = h;
        options.end = 12 * h;
        Samples samples;
        SimulationReport report;
        try {
          report = simulate(model, options, samples);
        } catch (const Error&) {  // a driver at a dead point, or a singular position
          continue;
        }
        ASSERT_TRUE(report.local_errors) << method;
        double sum = 0;
        // the first steps have too few states before them to be estimated
        for (std::size_t n = samples.all.size() - 1 - report.local_errors->steps; n + 1 < samples.all.size();
             ++n) {
          SimulationOptions exactly;
          exactly.integrator = "rkf78";
          exactly.tolerances = {1e-13, 1e-15};
          exactly.end = samples.all[n + 1].state.t;
          Samples one;
          try {
            simulate(Model<double>{model.mechanism, samples.all[n].state}, exactly, one);
          } catch (const Error&) {
            // index 3 leaves velocities off redundant rows: no exact motion starts there
            sum = 0;
            break;
          }
          double largest = 0;
          for (std::size_t b = 0; b < one.all.back().state.pose.size(); ++b)
            raise(largest, points_apart(one.all.back(), samples.all[n + 1], b, reach[b]));
          sum += largest;
        }
        if (sum < 1e-13) continue;
        ratios.push_back(report.local_errors->position / sum);
        EXPECT_GE(ratios.back(), 0.2) << name << ", " << method << ", " << h;
      }
  std::sort(ratios.begin(), ratios.end());
  EXPECT_GE(ratios.size(), 300u);
  EXPECT_LE(ratios[ratios.size() / 2], 5);
}

}  // namespace
}  // namespace trivium
