#pragma once
/// The laws of a method: the second half of the concept Method, which C++ types cannot express. `broken_laws`
/// tests the claims of a list entry on the spherical pendulum (contract/spherical_pendulum.hpp) and returns
/// those that do not hold. The bounds are chosen by experiment: every method of the list fulfils them, and a
/// method whose order is wrong by 1 does not.

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "integrators/contract/laws.hpp"
#include "integrators/contract/spherical_pendulum.hpp"
#include "integrators/methods.hpp"
#include "integrators/projection_iteration.hpp"

namespace trivium::integrators {

namespace detail {

/// Evaluates the laws of a list entry and lists those that do not hold.
class MethodLaws {
 public:
  explicit MethodLaws(const MethodEntry<double>& entry) : entry_(entry) {}

  std::vector<BrokenLaw> broken() {
    at_most("a method takes given steps, chooses its steps, or both",
            entry_.info.takes_given_steps || entry_.info.chooses_steps ? 0 : 1, 0);
    if (entry_.info.takes_given_steps) given_steps();
    if (entry_.info.chooses_steps) chosen_steps();
    return broken_;
  }

 private:
  using Y = StateVector<double>;
  static constexpr double end = 0.5;

  struct Run {
    std::unique_ptr<AnyMethod<double>> method;
    Y y;
    double y_error = 0, lambda_error = 0;
    bool lands = true;  ///< no step went backwards or beyond its stop
  };

  void at_most(const char* law, double figure, double bound) {
    if (!(figure <= bound)) broken_.push_back({law, figure, bound});
  }

  /// Integrates to `end` in intervals of equal length; a given step covers one interval. Restarts the method
  /// before interval number `restarted`, counted from 0; never if it is negative.
  static Run run(const MethodEntry<double>& entry, Steps steps, const Tolerances& tolerances, int intervals,
                 int restarted = -1) {
    Run run{make_method(entry, steps, tolerances), {}};
    SphericalPendulum<double> pendulum;
    SystemAdapter<SphericalPendulum<double>> system(pendulum);
    ProjectionIteration<AnySystem<double>> project;
    ProjectionReport<double> report;
    run.y = pendulum.start();
    double t = 0;
    for (int k = 1; k <= intervals; ++k) {
      const double stop = end * k / intervals;
      if (k - 1 == restarted) run.method->restart();
      while (t < stop) {
        const double before = t;
        run.method->step(system, t, run.y, stop);
        if (!(t > before && t <= stop) || (steps == Steps::given && t != stop)) run.lands = false;
        if (!run.lands) return run;
        if (!entry.info.meets_constraints) project(system, t, run.y, report);
      }
    }
    return run;
  }
  /// The same run, with its errors: the distance from a run of order 8 with 200 steps.
  Run run(Steps steps, const Tolerances& tolerances, int intervals, int restarted = -1) const {
    static const Y exact = run(method_entry<double>("rkf78"), Steps::given, {}, 200).y;
    Run found = run(entry_, steps, tolerances, intervals, restarted);
    found.y_error = (found.y - exact).norm();
    if (const Y* own = found.method->lambda()) {
      Y v_dot, lambda;
      SphericalPendulum<double>().accelerations(0, exact, v_dot, lambda);
      found.lambda_error = std::abs((*own - lambda)[0] / lambda[0]);
    }
    return found;
  }

  void given_steps() {
    const int coarse_steps = entry_.info.order > 6 ? 8 : 64;  // with more steps a high order is all rounding
    const Run coarse = run(Steps::given, {}, coarse_steps), fine = run(Steps::given, {}, 2 * coarse_steps);
    at_most("a given step ends at the requested time", coarse.lands ? 0 : 1, 0);
    if (!coarse.lands) return;
    at_most("counters: steps is the number of steps taken",
            std::abs(static_cast<double>(coarse.method->counters().steps) - coarse_steps), 0);
    // only errors above rounding show an order
    if (entry_.info.order > 0 && fine.y_error > 1e-12)
      at_most("the error of y decreases with the declared order",
              std::abs(std::log2(coarse.y_error / fine.y_error) - entry_.info.order), 0.5);
    if (entry_.info.has_raw_lambda && entry_.info.raw_lambda_order > 0 && fine.lambda_error > 1e-11)
      at_most("the error of the method's own multipliers decreases with the declared order",
              std::abs(std::log2(coarse.lambda_error / fine.lambda_error) - entry_.info.raw_lambda_order),
              0.5);
    at_most("the error of y is small", fine.y_error, 0.05);
    at_most("a restart within the run keeps the accuracy",
            run(Steps::given, {}, 2 * coarse_steps, coarse_steps).y_error, 10 * coarse.y_error + 1e-12);
    own_multipliers(fine);
    if (entry_.info.order == 0)
      at_most("a method without a fixed order takes the order as a parameter",
              entry_.info.takes_order ? 0 : 1, 0);
    restarts(Steps::given);
  }
  /// After a restart a method does the same as a new one.
  void restarts(Steps steps) {
    const Tolerances tolerances{1e-6, 1e-6};
    const auto used = make_method(entry_, steps, tolerances), fresh = make_method(entry_, steps, tolerances);
    SphericalPendulum<double> pendulum;
    SystemAdapter<SphericalPendulum<double>> system(pendulum);
    Y y = pendulum.start();
    double t = 0;
    for (int k = 1; k <= 5; ++k)
      for (const double stop = 0.02 * k; t < stop;) used->step(system, t, y, stop);
    Y again = y;
    double t_again = t;
    used->restart();
    used->step(system, t, y, 0.12);
    fresh->step(system, t_again, again, 0.12);
    at_most("the step after a restart is as long as the first step of a new method", std::abs(t - t_again),
            0);
    at_most("the step after a restart returns the state of a new method's first step", (y - again).norm(), 0);
    const Counters& counted = used->counters();
    at_most("counters are not negative",
            std::min({counted.steps, counted.rejected_steps, counted.right_sides, counted.restarts,
                      counted.iterations}) < 0
                ? 1
                : 0,
            0);
  }
  void chosen_steps() {
    const Run loose = run(Steps::chosen, {1e-4, 1e-4}, 3), tight = run(Steps::chosen, {1e-8, 1e-8}, 3);
    at_most("a chosen step goes forward and not beyond the requested end", loose.lands && tight.lands ? 0 : 1,
            0);
    if (!loose.lands || !tight.lands) return;
    // the errors of all steps add up
    at_most("the error of y decreases with the tolerance", tight.y_error,
            std::min(5e-8 * static_cast<double>(tight.method->counters().steps), loose.y_error / 10));
    own_multipliers(tight);
    at_most("the method's own multipliers are accurate at tight tolerances", tight.lambda_error, 1e-3);
    shortens();
    restarts(Steps::chosen);
  }
  void own_multipliers(const Run& of) {
    at_most("lambda returns multipliers if and only if has_raw_lambda is declared",
            (of.method->lambda() != nullptr) == entry_.info.has_raw_lambda ? 0 : 1, 0);
    at_most("the method's own multipliers are close to those of the state", of.lambda_error, 0.05);
    if (!entry_.info.meets_constraints) return;
    SphericalPendulum<double> pendulum;
    at_most("positions satisfy the constraints without projection if meets_constraints is declared",
            pendulum.position_violation(0, of.y).size, 1e-12);
  }
  /// If a step is taken back, the next one is shorter.
  void shortens() {
    const auto method = make_method(entry_, Steps::chosen, {1e-6, 1e-6});
    SphericalPendulum<double> pendulum;
    SystemAdapter<SphericalPendulum<double>> system(pendulum);
    Y y = pendulum.start(), again = y;
    double t = 0, t_again = 0;
    method->step(system, t, y, end);
    at_most("shorten returns true for a method that chooses its steps", method->shorten() ? 0 : 1, 0);
    method->step(system, t_again, again, end);
    at_most("the step after shorten is at most half as long", t_again, t / 2);
  }

  const MethodEntry<double> entry_;
  std::vector<BrokenLaw> broken_;
};

}  // namespace detail

/// Returns the claims of an entry that do not hold.
inline std::vector<BrokenLaw> broken_laws(const MethodEntry<double>& entry) {
  return detail::MethodLaws(entry).broken();
}

}  // namespace trivium::integrators
