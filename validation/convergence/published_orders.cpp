#include "validation/convergence/published_orders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "integrators/methods.hpp"

namespace trivium::convergence {

std::vector<Case> cases() {
  std::vector<Case> all;
  // the orders are those that the method's entry says
  const auto add = [&](std::string label, const std::string& method, int steps,
                       const integrators::MethodParameters& parameters = {}) -> Case& {
    const integrators::MethodInfo& info = *integrators::find_method(method);
    const int order = parameters.order.value_or(info.order),
              own = info.has_own_lambda ? parameters.order.value_or(info.own_lambda_order) : 0;
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
  add("hht", "hht", 200).needs_constant_mass = true;
  add("hht, alpha = 0", "hht", 50, {.alpha = 0.0}).raw_order = 0;
  add("radau5", "radau5", 20);
  // starts differ less on the slider-crank, and two errors above 1e-16 are too few
  add("radau9", "radau9", 6).floor = 5e-18;
  add("rattle", "rattle", 50);
  add("rattle4", "rattle4", 20);
  for (int k = 1; k <= 5; ++k) add(fmt::format("bdf{}", k), "bdf", k < 3 ? 400 : 100, {.order = k});
  const auto add_library = [&](const char* method, int order, int steps) {
    add(fmt::format("{}, {}", method, order), method, steps, {.order = order}).is_double = true;
  };
  // 8 comes down to rounding before its slope shows
  for (const auto& [k, steps] : {std::pair(2, 200), {3, 50}, {4, 20}, {5, 6}, {6, 6}})
    add_library("arkode-erk", k, steps);
  for (const auto& [k, steps] : {std::pair(2, 200), {3, 50}, {4, 20}, {5, 10}})
    add_library("arkode-dirk", k, steps);
  // who enters the list of methods is observed, whether there is a line above or not
  for (const integrators::MethodInfo& info : integrators::methods()) {
    const bool is_there =
        std::any_of(all.begin(), all.end(), [&](const Case& c) { return c.method == info.name; });
    const std::string name(info.name);
    if (info.takes_given_steps && !is_there) add(name, name, 100);
  }
  return all;
}

}  // namespace trivium::convergence
