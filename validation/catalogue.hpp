#pragma once
/// Scenes by name or path, and how programs on them end.

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "scenes/scene.hpp"
#include "validation/exit_code.hpp"

namespace trivium {

/// The folder of the catalogue: $TRIVIUM_SCENES, else share/trivium/scenes beside the installed program, else
/// the source tree's.
std::filesystem::path catalogue_directory();

/// All scene files of the catalogue, sorted by name.
std::vector<std::filesystem::path> catalogue();

/// A path as given, or the catalogue's scene of that name. Throws scenes::SceneError.
scenes::Scene load_scene(const std::string& path_or_name);

/// A scene whose state at time t does not satisfy its constraints, with the offending rows.
class InconsistentState : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The same, and its state at time t must satisfy its constraints; throws InconsistentState otherwise.
scenes::Scene load_consistent_scene(const std::string& path_or_name, double t);

/// Runs a program: what its input did wrong becomes exit code 2, what a solver could not do 3, each with its
/// message on stderr.
int run_guarded(const std::function<int()>& program);

}  // namespace trivium
