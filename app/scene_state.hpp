#pragma once
/// The scene and state that a subcommand works on: read, checked for consistency, assembled if asked.

#include <fmt/format.h>

#include <cstdio>
#include <optional>
#include <string>

#include "formulations/assembly.hpp"
#include "scenes/scene_file.hpp"
#include "validation/catalogue.hpp"

namespace trivium {

struct SceneArguments {
  std::string scene;
  double t = 0;
  bool assemble = false;
  std::string save;  ///< file for the assembled scene; empty for none
};

/// Reads the scene and, with `assemble`, projects its state onto the constraints and saves it if asked.
inline scenes::Scene load_state(const SceneArguments& arguments) {
  scenes::Scene scene = load_scene(arguments.scene);
  if (!arguments.assemble) return scene;
  const auto mechanism = make_mechanism<double>(scene);
  set_state(scene, assemble(mechanism, make_state<double>(scene, arguments.t)));
  if (!arguments.save.empty()) scenes::write_scene_file(arguments.save, scene);
  return scene;
}

/// Whether the state satisfies its constraints.
inline Consistency consistency_of(const scenes::Scene& scene, double t) {
  return check_consistency(make_mechanism<double>(scene), make_state<double>(scene, t));
}

/// Says on stderr what does not hold; true if all does.
inline bool report_consistency(const SceneArguments& arguments, const Consistency& consistency) {
  if (consistency.holds()) return true;
  fmt::print(stderr, "error: {}: the state at t = {} does not satisfy its constraints:\n{}", arguments.scene,
             arguments.t, consistency.report());
  fmt::print(stderr, "--assemble projects it onto them\n");
  return false;
}

}  // namespace trivium
