#pragma once
/// The loads of each effect by itself. Messages about failed steps name the effect whose load is no number
/// that a motion can follow, and the one that loads a body most. Where loads cancel, their sizes tell
/// rounding from motion.

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "effects/effect_list.hpp"

namespace trivium {

/// Type and name of each effect, with its loads on all bodies.
template <class S, class List>
std::vector<std::pair<std::string, std::vector<Wrench<S>>>> loads_by_effect(const Effects<S, List>& effects,
                                                                            const EffectView<S>& view) {
  std::vector<std::pair<std::string, std::vector<Wrench<S>>>> loads;
  const auto add = [&](const auto& effect) {
    auto& [name, wrenches] = loads.emplace_back();
    name =
        effect.name.empty() ? std::string(effect.type) : fmt::format("{} \"{}\"", effect.type, effect.name);
    wrenches.resize(view.bodies.size() + 1);
    effect.apply(view, wrenches);
  };
  std::apply([&](const auto&... list) { (std::for_each(list.begin(), list.end(), add), ...); },
             effects.lists());
  return loads;
}

/// The first effect whose load on a body is not finite or exceeds `most` [N, N m]; empty if there is none.
template <class S, class List>
std::string effect_above(const Effects<S, List>& effects, const EffectView<S>& view, const S& most) {
  for (const auto& [name, wrenches] : loads_by_effect(effects, view))
    for (const Wrench<S>& on : wrenches)
      if (!(on.F.squaredNorm() <= most * most && on.n_bar.squaredNorm() <= most * most)) return name;
  return {};
}

/// The effect with the largest load on a body; empty if none loads it by more than `least` [N + N m].
template <class S, class List>
std::string largest_load(const Effects<S, List>& effects, const EffectView<S>& view, int body, S least) {
  std::string largest;
  S most = least;
  for (const auto& [name, wrenches] : loads_by_effect(effects, view))
    if (const S size = wrenches[body].F.norm() + wrenches[body].n_bar.norm(); size > most) {
      most = size;
      largest = name;
    }
  return largest;
}

/// The sums of the absolute values of all loads on each body, component by component; the loads may cancel.
template <class S, class List>
std::vector<Wrench<S>> load_sizes(const Effects<S, List>& effects, const EffectView<S>& view) {
  std::vector<Wrench<S>> sizes(view.bodies.size());
  for (const auto& [name, wrenches] : loads_by_effect(effects, view))
    for (std::size_t b = 0; b < sizes.size(); ++b) {
      sizes[b].F += wrenches[b].F.cwiseAbs();
      sizes[b].n_bar += wrenches[b].n_bar.cwiseAbs();
    }
  return sizes;
}

}  // namespace trivium
