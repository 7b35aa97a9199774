#include "validation/convergence/published_orders.hpp"

#include <fmt/format.h>

#include <utility>

namespace trivium::convergence {

std::vector<Case> cases() {
  std::vector<Case> all{{"dopri5", "dopri5", {}, 5, 0, 20},
                        {"rkf78", "rkf78", {}, 8, 0, 4},
                        {"abm", "abm", {}, 5, 0, 160},
                        {"hedop5", "hedop5", {}, 5, 4, 80, false, false, "double_pendulum"},
                        {"hem4", "hem4", {}, 4, 2, 20},
                        {"generalized-alpha", "generalized-alpha", {}, 2, 2, 100},
                        {"generalized-alpha-gl2", "generalized-alpha-gl2", {}, 2, 2, 50},
                        {"hht", "hht", {.alpha = -0.2}, 2, 2, 200, true},
                        {"hht, alpha = 0", "hht", {.alpha = 0.0}, 2, 0, 50},
                        {"radau5", "radau5", {}, 5, 3, 20},
                        // starts differ less on the slider-crank, and two errors above 1e-16 are too few
                        {"radau9", "radau9", {}, 9, 5, 6, false, false, "spatial_slider_crank", 5e-18},
                        {"rattle", "rattle", {}, 2, 2, 50},
                        {"rattle4", "rattle4", {}, 4, 2, 20}};
  for (int k = 1; k <= 5; ++k)
    all.push_back({fmt::format("bdf{}", k), "bdf", {.order = k}, k, k, k < 3 ? 400 : 100});
  // 8 comes down to rounding before its slope shows
  for (const auto& [k, steps] : {std::pair(2, 200), {3, 50}, {4, 20}, {5, 6}, {6, 6}})
    all.push_back({fmt::format("arkode-erk, {}", k), "arkode-erk", {.order = k}, k, 0, steps, false, true});
  for (const auto& [k, steps] : {std::pair(2, 200), {3, 50}, {4, 20}, {5, 10}})
    all.push_back({fmt::format("arkode-dirk, {}", k), "arkode-dirk", {.order = k}, k, 0, steps, false, true});
  return all;
}

}  // namespace trivium::convergence
