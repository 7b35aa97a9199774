/// The runs that show the order of each method: parameters, numbers of steps, and floors of the errors.

#include "validation/convergence/published_orders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "integrators/methods.hpp"

namespace trivium::convergence {

std::vector<Case> cases() {
  std::vector<Case> all;
  // the published orders are those in the method's entry
  const auto add = [&](std::string label, const std::string& method, int steps,
                       const integrators::MethodParameters& parameters = {}) -> Case& {
    const integrators::MethodInfo& info = *integrators::find_method(method);
    const int order = parameters.order.value_or(info.order),
              own = info.has_raw_lambda ? parameters.order.value_or(info.raw_lambda_order) : 0;
    all.push_back({std::move(label), method, parameters, order, own, steps});
    return all.back();
  };
  add("dopri5", "dopri5", 20);
  add("rkf78", "rkf78", 4);
  add("abm", "abm", 160);
  add("hedop5", "hedop5", 80).scene = "double_pendulum";
  add("hem4", "hem4", 20);
  add("generalized-alpha", "generalized-alpha", 100);
  add("generalized-alpha-gl2", "generalized-alpha-gl2", 50);
  add("hht", "hht", 200);
  // without damping the raw lambda of hht oscillates
  add("hht, alpha = 0", "hht", 50, {.alpha = 0.0}).raw_order = 0;
  add("radau5", "radau5", 20);
  // On the slider-crank the initial states in quad agree better than 1e-16, and only two errors of radau9
  // exceed 1e-16.
  add("radau9", "radau9", 6).floor = 5e-18;
  add("rattle", "rattle", 50);
  add("rattle4", "rattle4", 20);
  for (int k = 1; k <= 5; ++k) add(fmt::format("bdf{}", k), "bdf", k < 3 ? 400 : 100, {.order = k});
  const auto add_library = [&](const char* method, int order, int steps) {
    add(fmt::format("{}, {}", method, order), method, steps, {.order = order}).is_double = true;
  };
  // arkode-erk of order 8 reaches rounding before its slope is visible
  for (const auto& [k, steps] : {std::pair(2, 200), {3, 50}, {4, 20}, {5, 6}, {6, 6}})
    add_library("arkode-erk", k, steps);
  for (const auto& [k, steps] : {std::pair(2, 200), {3, 50}, {4, 20}, {5, 10}})
    add_library("arkode-dirk", k, steps);
  // A method of the list without a line above is observed too, with 100 steps.
  for (const integrators::MethodInfo& info : integrators::methods()) {
    const bool is_there =
        std::any_of(all.begin(), all.end(), [&](const Case& c) { return c.method == info.name; });
    const std::string name(info.name);
    if (info.takes_given_steps && !is_there) add(name, name, 100);
  }
  return all;
}

}  // namespace trivium::convergence
