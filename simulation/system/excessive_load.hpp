#pragma once
/// Finds the effect whose load is no number that a motion can follow. Messages about failed steps name it as
/// the cause.

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "effects/effect_list.hpp"

namespace trivium {

/// Type and name of the first effect whose load on a body is not finite or exceeds `most` [N, N m]; empty if
/// there is none.
template <class S, class List>
std::string excessive_load(const Effects<S, List>& effects, const EffectView<S>& view, const S& most) {
  std::string found;
  std::vector<Wrench<S>> wrenches(view.bodies.size() + 1);
  const auto examine = [&](const auto& effect) {
    if (!found.empty()) return;
    std::fill(wrenches.begin(), wrenches.end(), Wrench<S>{});
    effect.apply(view, wrenches);
    for (const Wrench<S>& on : wrenches)
      if (!(on.F.squaredNorm() <= most * most && on.n_bar.squaredNorm() <= most * most))
        found = fmt::format("{} \"{}\"", effect.type, effect.name);
  };
  std::apply([&](const auto&... list) { (std::for_each(list.begin(), list.end(), examine), ...); },
             effects.lists());
  return found;
}

}  // namespace trivium
