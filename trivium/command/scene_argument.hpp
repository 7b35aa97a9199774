#pragma once
/// The scene that a subcommand works on: its options, and the state that they ask for, read and assembled.
/// Whether the state is fit to be solved is the front door's to say (state_check.hpp).

#include <optional>
#include <string>

#include "base/program_options.hpp"
#include "mechanism/model.hpp"
#include "scenes/scene.hpp"

namespace trivium {

struct SceneArguments {
  std::string scene;
  std::optional<double> t;  ///< of the state [s]; else that of a saved run, or 0
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

}  // namespace trivium
