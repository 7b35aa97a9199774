/// Repeats the motion twice, and takes the output at which the first two motions differ most.

#include "simulation/step_verification.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/raise.hpp"
#include "integrators/methods.hpp"
#include "simulation/neighbouring_start.hpp"

namespace trivium {

namespace {

/// A quantity of a motion: the largest difference between two samples at the same time, and its size, to
/// which rounding is relative.
struct Quantity {
  const char *name, *unit;
  std::function<double(const MotionSample&, const MotionSample&)> difference;
  std::function<double(const MotionSample&)> size;
  int rate_of = -1;  ///< place of the quantity that changes at this rate; -1: none
};

bool has_unique_multiplier(const std::vector<MotionSample>& samples) {
  return std::any_of(samples.begin(), samples.end(), [](const MotionSample& sample) {
    return std::count(sample.lambda_unique.begin(), sample.lambda_unique.end(), true) > 0;
  });
}

/// The largest value of of(b) over the bodies of a sample.
template <class Of>
double over_bodies(const MotionSample& sample, const Of& of) {
  double largest = 0;
  for (std::size_t b = 0; b < sample.state.pose.size(); ++b) raise(largest, static_cast<double>(of(b)));
  return largest;
}

std::vector<Quantity> quantities() {
  return {{"positions", "m",
           [](const MotionSample& a, const MotionSample& b) {
             return over_bodies(a, [&](auto k) { return (a.state.pose[k].r - b.state.pose[k].r).norm(); });
           },
           [](const MotionSample& a) {
             return over_bodies(a, [&](auto k) { return a.state.pose[k].r.norm(); });
           }},
          {"orientations", "rad",
           [](const MotionSample& a, const MotionSample& b) {
             return over_bodies(a,
                                [&](auto k) { return turn_between(a.state.pose[k].p, b.state.pose[k].p); });
           },
           [](const MotionSample&) { return 1.0; }},
          {"velocities", "m/s",
           [](const MotionSample& a, const MotionSample& b) {
             return over_bodies(
                 a, [&](auto k) { return (a.state.twist[k].r_dot - b.state.twist[k].r_dot).norm(); });
           },
           [](const MotionSample& a) {
             return over_bodies(a, [&](auto k) { return a.state.twist[k].r_dot.norm(); });
           },
           0},
          {"angular velocities", "rad/s",
           [](const MotionSample& a, const MotionSample& b) {
             return over_bodies(
                 a, [&](auto k) { return (a.state.twist[k].omega_bar - b.state.twist[k].omega_bar).norm(); });
           },
           [](const MotionSample& a) {
             return over_bodies(a, [&](auto k) { return a.state.twist[k].omega_bar.norm(); });
           },
           1},
          {"lambda", "unit of the row",
           [](const MotionSample& a, const MotionSample& b) {
             double largest = 0;
             for (Eigen::Index k = 0; k < a.lambda.size(); ++k)
               if (a.lambda_unique[k] && b.lambda_unique[k])
                 raise(largest, std::abs(a.lambda[k] - b.lambda[k]));
             return largest;
           },
           [](const MotionSample& a) { return largest_magnitude(a.lambda); }}};
}

}  // namespace

std::vector<ErrorByHalving> verify_steps(const Model<double>& model, const SimulationOptions& options) {
  if (!options.step) throw integrators::UsageError("a motion is verified by halving its steps: give a step");
  const double steps = (options.end - model.state.t) / *options.step;
  const auto repeated = [&](int parts) {
    SimulationOptions finer = options;
    finer.step = *options.step / parts;
    // the end alone may be alike where the motion is not, such as a position of rest
    if (!options.output_step) finer.output_step = *options.step * std::max(1.0, std::ceil(steps / 100));
    if (finer.from) finer.from->memory.clear();  // it belongs to steps of the coarse length
    Samples samples;
    simulate(model, finer, samples);
    return samples.all;
  };
  const std::vector<MotionSample> coarse = repeated(1), half = repeated(2), quarter = repeated(4);
  const integrators::MethodInfo& info =
      options.own_method ? options.own_method->info : *integrators::find_method(options.integrator);
  const int order = options.parameters.order.value_or(info.standard_order);
  std::vector<ErrorByHalving> errors;
  std::vector<Quantity> compared = quantities();
  if (!has_unique_multiplier(coarse)) compared.pop_back();  // lambda, of which nothing is determined
  std::vector<double> sizes;
  for (const Quantity& of : compared) {
    ErrorByHalving& found = errors.emplace_back();
    found.quantity = of.name;
    found.unit = of.unit;
    found.expected_order = order;
    double first = 0, second = 0, size = 0;
    const std::size_t outputs = std::min({coarse.size(), half.size(), quarter.size()});
    for (std::size_t k = 0; k < outputs; ++k) {
      raise(size, of.size(coarse[k]));
      const double difference = of.difference(coarse[k], half[k]);
      if (difference <= first) continue;
      first = difference;
      second = of.difference(half[k], quarter[k]);
      found.t = coarse[k].state.t;
    }
    sizes.push_back(size);
    // a rate so small that nothing moves in the whole run, as that of a body that is held, is rounding too
    const double moving = of.rate_of < 0 ? 0 : sizes[of.rate_of] / (options.end - model.state.t);
    // the rounding of a thousand steps is 1e-13 of the size of the quantity
    const double rounding = 1e-13 * std::max(size, moving) * std::max(1.0, 4 * steps / 1000);
    // Differences so small that hardly fall are rounding too: a fast spin gathers more of it.
    const double halvings = second > 0 ? std::log2(first / second) : HUGE_VAL;
    const bool is_rounding = first <= rounding || (first <= 1e-9 * size && halvings < order / 2.0);
    if (!is_rounding) found.order = halvings;
    // An observed order near 0 would make the divisor 1 - 2^-p nearly 0 and the error arbitrarily large,
    // hence p is at least 0.5, chosen by experiment. An observed order above the method's is chance.
    const double p = found.order ? std::clamp(*found.order, 0.5, static_cast<double>(order)) : order;
    found.error = (first + rounding) / (1 - std::exp2(-p));
  }
  return errors;
}

}  // namespace trivium
