#pragma once
/// The scene that a subcommand works on: its options, and the state that they ask for, read and assembled.
/// Decides whether the state is fit to be solved: it must satisfy its constraints.

#include <functional>
#include <string>

#include "base/program_options.hpp"
#include "formulations/analysis/consistency.hpp"
#include "mechanism/model.hpp"
#include "scenes/scene.hpp"

namespace trivium {

struct SceneArguments {
  std::string scene;
  double t = 0;
  bool assemble = false;
  std::string save;  ///< file for the assembled scene; empty for none
};

/// The options that say which scene, at what time and whether to assemble it.
void add_scene_options(ProgramOptions& options, SceneArguments& arguments);

/// A scene as the file has it or as it was assembled, and its model, made once.
struct LoadedScene {
  scenes::Scene scene;
  Model<double> model;
};

/// Reads the scene and, with `assemble`, projects its state onto the constraints and saves it if asked.
LoadedScene load(const SceneArguments& arguments);

/// Says on stderr what does not hold; true if all does.
bool report_consistency(const SceneArguments& arguments, const Consistency& consistency);

/// Runs a subcommand; a ModelError carries the scene as the command line names it.
int naming_scene(const SceneArguments& arguments, const std::function<int()>& run);

}  // namespace trivium
