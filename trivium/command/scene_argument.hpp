#pragma once
/// The scene and state that a subcommand works on: read, checked for consistency, assembled if asked.

#include <fmt/format.h>

#include <cstdio>
#include <optional>
#include <string>

#include "base/command_line.hpp"
#include "base/error.hpp"
#include "base/program_options.hpp"
#include "formulations/analysis/assemble.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/format/scene_file.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/scene_state.hpp"

namespace trivium {

struct SceneArguments {
  std::string scene;
  double t = 0;
  bool assemble = false;
  std::string save;  ///< file for the assembled scene; empty for none
};

/// The options that say which scene, at what time and whether to assemble it.
inline void add_scene_options(ProgramOptions& options, SceneArguments& arguments) {
  options.add_option("SCENE", &arguments.scene, "A scene file, or the name of a catalogue scene").required();
  options.add_option("--t", &arguments.t, "The time at which the file's state is taken [s]")
      .check(finite_time())
      .show_default();
  const ProgramOption assemble =
      options.add_flag("--assemble", &arguments.assemble, "First project the state onto its constraints");
  options.add_option("--save", &arguments.save, "With --assemble: write the assembled scene to this file")
      .check(writable_file())
      .needs(assemble);
}

/// Runs a subcommand; a ModelError carries the scene as the command line names it.
inline int naming_scene(const SceneArguments& arguments, const std::function<int()>& run) {
  try {
    return run();
  } catch (const ModelError& error) {
    throw ModelError(name_source(arguments.scene, error.what()));
  }
}

/// Reads the scene and, with `assemble`, projects its state onto the constraints and saves it if asked.
inline scenes::Scene load_state(const SceneArguments& arguments) {
  scenes::Scene scene = load_scene(arguments.scene, arguments.t);
  if (!arguments.assemble) return scene;
  const auto mechanism = make_mechanism<double>(scene);
  set_state(scene, assemble(mechanism, make_state<double>(scene, arguments.t)));
  if (!arguments.save.empty()) scenes::write_scene_file(arguments.save, scene);
  return scene;
}

/// Whether the state satisfies its constraints.
inline Consistency consistency_of(const Model<double>& model) {
  return check_consistency(model.mechanism, model.state);
}

/// Says on stderr what does not hold; true if all does.
inline bool report_consistency(const SceneArguments& arguments, const Consistency& consistency) {
  if (consistency.holds()) return true;
  fmt::print(stderr, "error: {}: the state at t = {} does not satisfy its constraints:\n{}", arguments.scene,
             arguments.t, consistency.report());
  if (!consistency.holds_rows()) fmt::print(stderr, "--assemble projects it onto them\n");
  if (!consistency.wrong_branches.empty()) fmt::print(stderr, "{}\n", wrong_branch_advice);
  return false;
}

}  // namespace trivium
