#pragma once
/// The scene that a subcommand works on: the command-line options that name it, and the function that reads
/// it and assembles its state if requested. state_check.hpp decides whether the state is consistent.

#include <optional>
#include <string>

#include "base/program_options.hpp"
#include "mechanism/model.hpp"
#include "scenes/scene.hpp"

namespace trivium {

struct SceneArguments {
  std::string scene;
  std::optional<double> t;  ///< time of the state [s]; none: the time of the saved run, else 0
  bool assemble = false;    ///< project the state onto the constraints
  std::optional<double> rank_tolerance;
  std::string save;  ///< file for the assembled scene; empty: none
};

/// Adds the options of the scene, the time of its state, its rank tolerance, and its assembly.
void add_scene_options(ProgramOptions& options, SceneArguments& arguments);

/// A scene, as read or as assembled, and its model.
struct LoadedScene {
  scenes::Scene scene;
  Model<double> model;
};

/// Reads the scene. With `assemble`, projects its state onto the constraints, and writes it if `save` is
/// given. Throws an Error of kind input for a wrong scene, and as assemble() does.
LoadedScene load(const SceneArguments& arguments);

}  // namespace trivium
