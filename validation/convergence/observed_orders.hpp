#pragma once
/// Observes the order of a method: the errors of r, v, lambda and the method's own ("raw") lambda at
/// successively halved steps, and log2 of the ratio of neighbouring errors. This file decides which errors
/// are large enough to show an order, and how far the observed order may be from the published one.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "bodies/numbers/quad.hpp"
#include "simulation/simulate.hpp"
#include "validation/convergence/published_orders.hpp"
#include "validation/harness/named_scene.hpp"

namespace trivium::convergence {

/// Largest accepted difference between observed and published order, chosen by experiment. It distinguishes
/// orders, which are whole numbers, and admits errors of higher order at finite step sizes.
constexpr double tolerance = 0.2;

constexpr std::array<const char*, 4> quantities{"r", "v", "lambda", "raw lambda"};
using Errors = std::array<double, 4>;

/// The errors and orders of one case in one formulation.
struct OrderResult {
  std::string scene, formulation, error;
  Case of;
  std::vector<double> h;
  std::vector<Errors> errors;
  Errors floor{};  ///< errors at or below this value are rounding

  bool solved() const { return error.empty(); }
  bool has(int quantity) const { return quantity < 3 || of.raw_order > 0; }
  double observed(int quantity, std::size_t level) const {
    return std::log2(errors[level - 1][quantity] / errors[level][quantity]);
  }
  /// Whether every error is a number. An error is NaN if the method reports no raw lambda, or if the run
  /// produced NaN.
  bool is_known(int quantity) const {
    return std::all_of(errors.begin(), errors.end(),
                       [&](const Errors& at) { return std::isfinite(at[quantity]); });
  }
  /// The index of the finest step size (in h) whose error is above rounding. The order is observed between
  /// this level and the coarser one before it. With the result 0 there is no coarser one, and no order.
  std::size_t level(int quantity) const {
    std::size_t k = h.size() - 1;
    while (k > 0 && !(errors[k][quantity] > floor[quantity])) --k;
    return k;
  }
  bool is_rounding(int quantity) const { return is_known(quantity) && level(quantity) == 0; }
  double observed(int quantity) const { return observed(quantity, level(quantity)); }
  int published(int quantity) const { return quantity == 3 ? of.raw_order : of.order; }
  bool passed(int quantity) const {
    if (!is_known(quantity) || level(quantity) == 0) return false;  // no order is observed
    return std::abs(observed(quantity) - published(quantity)) <= tolerance;
  }
  bool passed() const {
    if (!solved()) return false;
    for (int k = 0; k < 4; ++k)
      if (has(k) && !passed(k)) return false;
    return true;
  }
};

/// The models of a scene in double and in quad, made once for all runs.
struct TwoModels {
  explicit TwoModels(const NamedScene& named);
  const NamedScene& named;
  Model<Quad> in_quad;
};

/// The outputs of a run that are compared: at half time and at the end. The run is in quad, or in double.
std::vector<MotionSample> outputs_of(const TwoModels& models, SimulationOptions options,
                                     bool is_double = false);

/// The errors of one method in one formulation at `levels` step sizes, each half of the one before, relative
/// to the exact outputs. If a run fails, the result contains the error message.
OrderResult measure(const TwoModels& models, const std::string& formulation, const Case& of, double t_end,
                    int levels, const std::vector<MotionSample>& exact);

}  // namespace trivium::convergence
