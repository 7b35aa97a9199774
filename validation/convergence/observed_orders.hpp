#pragma once
/// The order that a run shows: errors of r, v, lambda and the method's own lambda at steps that halve, and
/// log2 of the ratio of neighbours. Decides down to which error an order is told from rounding, and how far
/// it may be from the published one.

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

/// Observed and published orders may differ by this.
constexpr double tolerance = 0.2;

constexpr std::array<const char*, 4> quantities{"r", "v", "lambda", "raw lambda"};
using Errors = std::array<double, 4>;

/// Of one case in one formulation.
struct OrderResult {
  std::string scene, formulation, error;
  Case of;
  std::vector<double> h;
  std::vector<Errors> errors;
  Errors floor{};  ///< what rounding leaves of errors

  bool solved() const { return error.empty(); }
  bool has(int quantity) const { return quantity < 3 || of.raw_order > 0; }
  double observed(int quantity, std::size_t level) const {
    return std::log2(errors[level - 1][quantity] / errors[level][quantity]);
  }
  /// Whether every error is a number: a run that reports no lambda of its own, or NaN, has none.
  bool is_known(int quantity) const {
    return std::all_of(errors.begin(), errors.end(),
                       [&](const Errors& at) { return std::isfinite(at[quantity]); });
  }
  /// The finest level that shows an order; 0 where none does.
  std::size_t level(int quantity) const {
    std::size_t k = h.size() - 1;
    while (k > 0 && !(errors[k][quantity] > floor[quantity])) --k;
    return k;
  }
  bool is_rounding(int quantity) const { return is_known(quantity) && level(quantity) == 0; }
  double observed(int quantity) const { return observed(quantity, level(quantity)); }
  double t_end() const { return h.front() * of.steps; }
  /// Whether the formulation's mass matrix lets the order fall.
  bool may_fall() const { return of.needs_constant_mass && !inertia_is_constant(formulation); }
  int published(int quantity) const { return quantity == 3 ? of.raw_order : of.order; }
  std::string expected(int quantity) const {
    return may_fall() ? fmt::format("1..{}", published(quantity)) : std::to_string(published(quantity));
  }
  bool passed(int quantity) const {
    if (!is_known(quantity) || level(quantity) == 0) return false;  // what shows no order proves none
    const double found = observed(quantity), p = published(quantity);
    if (!may_fall()) return std::abs(found - p) <= tolerance;
    // of r the part of order 1 is small, and may first cancel that of order 2: it falls at least as what the
    // errors of v add up to, which are of order 1 themselves
    if (quantity == 0)
      return found <= p + tolerance && found >= -tolerance && errors.back()[0] <= t_end() * errors.back()[1];
    return found <= p + tolerance && found >= 1 - tolerance;
  }
  bool passed() const {
    if (!solved()) return false;
    for (int k = 0; k < 4; ++k)
      if (has(k) && !passed(k)) return false;
    return true;
  }
};

/// A scene's models in the two precisions that orders are observed in, made once for all runs.
struct TwoModels {
  explicit TwoModels(const NamedScene& named);
  const NamedScene& named;
  Model<Quad> in_quad;
};

/// The outputs of a run that errors are measured at: its middle and its end. In quad, or in double.
std::vector<MotionSample> outputs_of(const TwoModels& models, SimulationOptions options,
                                     bool is_double = false);

/// The errors of one method in one formulation at `levels` steps, each half of the one before, against the
/// exact outputs. A run that fails is a result with an error.
OrderResult measure(const TwoModels& models, const std::string& formulation, const Case& of, double t_end,
                    int levels, const std::vector<MotionSample>& exact);

}  // namespace trivium::convergence
