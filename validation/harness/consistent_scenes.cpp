/// Loads all scenes before it throws, so that one error lists the problems of all scenes.

#include "validation/harness/consistent_scenes.hpp"

#include <fmt/format.h>

#include "formulations/analysis/assemble.hpp"
#include "scenes/format/scene_file.hpp"

namespace trivium {

InputErrors::InputErrors(const std::vector<std::string>& messages)
    : Error(ErrorKind::input, fmt::format("{}", fmt::join(messages, "\nerror: "))), messages_(messages) {}

namespace {

/// A report on the constraints that the scene's state violates; empty if there are none.
std::string inconsistency(const NamedScene& named) {
  try {
    const auto& [mechanism, state] = named.model();
    const Consistency consistency = check_consistency(mechanism, state);
    if (consistency.holds()) return {};
    std::string report = consistency.report();
    report.erase(report.find_last_not_of('\n') + 1);
    return fmt::format("{}: the state at t = {} does not satisfy its constraints:\n{}", named.source, named.t,
                       report);
  } catch (const ModelError&) {
    return {};  // the model has no equations at this state: the solver reports this later, as the result of
                // this one scene
  }
}

}  // namespace

std::vector<NamedScene> load_consistent_scenes(const std::vector<std::string>& paths_or_names, double t) {
  std::vector<NamedScene> scenes;
  std::vector<std::string> messages;
  for (const std::string& source : paths_or_names) {
    try {
      NamedScene named(source, load_scene(source, t), t);
      const std::string message = inconsistency(named);
      if (message.empty())
        scenes.push_back(std::move(named));
      else
        messages.push_back(message);
    } catch (const scenes::SceneError& error) {
      messages.emplace_back(error.what());
    }
  }
  if (!messages.empty()) throw InputErrors(messages);
  return scenes;
}

}  // namespace trivium
