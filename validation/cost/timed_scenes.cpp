/// Turns names such as "chain_100" into generated scenes; every other name is a scene of the catalogue or a
/// file.

#include "validation/cost/timed_scenes.hpp"

#include <charconv>
#include <optional>

#include "scenes/generators.hpp"
#include "validation/harness/consistent_scenes.hpp"

namespace trivium::cost {

namespace {

std::optional<TimedScene> generated(const std::string& name) {
  const std::size_t bar = name.rfind('_');
  if (bar == std::string::npos) return {};
  int n = 0;
  const char* end = name.data() + name.size();
  const auto [read, error] = std::from_chars(name.data() + bar + 1, end, n);
  const std::string kind = name.substr(0, bar);
  if (error != std::errc() || read != end || n < (kind == "ring" ? 3 : 1) || n > 100000) return {};
  const auto timed = [&](scenes::Scene scene) { return TimedScene{name, kind, n, std::move(scene)}; };
  if (kind == "chain") return timed(scenes::chain(n));
  if (kind == "ladder") return timed(scenes::ladder(n));
  if (kind == "tree") return timed(scenes::tree(n));
  if (kind == "ring") return timed(scenes::ring(n));
  if (kind == "hub") return timed(scenes::hub(n));
  return {};
}

}  // namespace

std::vector<TimedScene> timed_scenes(const std::vector<std::string>& names) {
  std::vector<TimedScene> all;
  std::vector<std::string> messages;
  for (const std::string& name : names) {
    if (auto scene = generated(name)) {
      all.push_back(std::move(*scene));
      continue;
    }
    try {
      NamedScene named = load_consistent_scenes({name}, 0).front();
      const std::string own_name = named.scene.name;
      all.push_back({own_name, own_name, 0, std::move(named.scene)});
    } catch (const InputErrors& errors) {
      messages.insert(messages.end(), errors.messages().begin(), errors.messages().end());
    }
  }
  if (!messages.empty()) throw InputErrors(messages);
  return all;
}

std::vector<std::string> default_scene_names(bool quick) {
  if (quick)
    return {"chain_1",   "chain_10", "chain_100",        "ladder_1", "ladder_10",
            "ladder_40", "tree_100", "stewart_platform", "ring_100", "hub_100"};
  return {"chain_1",     "chain_2",  "chain_10",         "chain_100", "chain_1000",
          "chain_10000", "ladder_1", "ladder_10",        "ladder_40", "ladder_100",
          "ladder_400",  "tree_100", "stewart_platform", "ring_100",  "hub_100"};
}

}  // namespace trivium::cost
