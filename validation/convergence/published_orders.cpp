#include "validation/convergence/published_orders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include "integrators/methods.hpp"

namespace trivium::convergence {

namespace {

/// The orders are those that the method's entry says.
Case entered(std::string name, std::string method, integrators::MethodParameters parameters, int steps) {
  const integrators::MethodInfo& info = *integrators::find_method(method);
  const int order = parameters.order.value_or(info.order),
            own = info.has_own_lambda ? parameters.order.value_or(info.own_lambda_order) : 0;
  return {std::move(name), std::move(method), parameters, order, own, steps};
}

}  // namespace

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const auto& [method, steps] : {std::pair("dopri5", 20),
                                      {"rkf78", 4},
                                      {"abm", 160},
                                      {"hedop5", 80},
                                      {"hem4", 20},
                                      {"generalized-alpha", 100},
                                      {"generalized-alpha-gl2", 50},
                                      {"hht", 200},
                                      {"radau5", 20},
                                      {"radau9", 6},
                                      {"rattle", 50},
                                      {"rattle4", 20}})
    all.push_back(entered(method, method, {}, steps));
  const auto of = [&](std::string_view name) -> Case& {
    return *std::find_if(all.begin(), all.end(), [&](const Case& c) { return c.label == name; });
  };
  of("hedop5").scene = "double_pendulum";
  of("hht").needs_constant_mass = true;
  // starts differ less on the slider-crank, and two errors above 1e-16 are too few
  of("radau9").scene = "spatial_slider_crank";
  of("radau9").floor = 5e-18;
  Case undamped = entered("hht, alpha = 0", "hht", {.alpha = 0.0}, 50);
  undamped.raw_order = 0;
  all.insert(std::next(all.begin(), &of("hht") - all.data() + 1), std::move(undamped));
  for (int k = 1; k <= 5; ++k)
    all.push_back(entered(fmt::format("bdf{}", k), "bdf", {.order = k}, k < 3 ? 400 : 100));
  const auto add_library = [&](const char* method, int order, int steps) {
    all.push_back(entered(fmt::format("{}, {}", method, order), method, {.order = order}, steps));
    all.back().is_double = true;
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
    if (info.takes_given_steps && !is_there)
      all.push_back(entered(std::string(info.name), std::string(info.name), {}, 100));
  }
  return all;
}

}  // namespace trivium::convergence
