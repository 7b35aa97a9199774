#pragma once
/// Scenes by name or path, and the exit codes that every executable keeps to.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace trivium {

enum ExitCode : int {
  exit_done = 0,
  exit_criterion_failed = 1,
  exit_input_error = 2,
  exit_solver_failed = 3
};

/// The folder of the catalogue: $TRIVIUM_SCENES, else share/trivium/scenes beside the installed program, else
/// the source tree's.
std::filesystem::path catalogue_directory();

/// All scene files of the catalogue, sorted by name.
std::vector<std::filesystem::path> catalogue();

/// A path as given, or the catalogue's scene of that name. Throws scenes::SceneError.
scenes::Scene load_scene(const std::string& path_or_name);

/// Runs a program: what its input did wrong becomes exit code 2, what a solver could not do 3, each with its
/// message on stderr.
int run_guarded(const std::function<int()>& program);

}  // namespace trivium
