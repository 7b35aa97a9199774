#pragma once
/// Scenes by name or path, and how programs on them end.

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "results/exit_code.hpp"
#include "scenes/scene.hpp"

namespace trivium {

/// The folder of the catalogue: $TRIVIUM_SCENES, else share/trivium/scenes beside the installed program, else
/// the source tree's.
std::filesystem::path catalogue_directory();

/// The folder of trusted numbers: $TRIVIUM_REFERENCE, else `reference` beside the catalogue's, else the
/// source tree's.
std::string reference_directory();

/// All scene files of the catalogue, sorted by name.
std::vector<std::filesystem::path> catalogue();

/// The state at t of a path as given, or of the catalogue's scene of that name, which no folder of the same
/// name hides. Throws scenes::SceneError.
scenes::Scene load_scene(const std::string& path_or_name, double t);

/// A scene and the path or name that it was asked for by, which messages about it carry.
struct NamedScene {
  std::string source;
  scenes::Scene scene;
};

/// Scenes that cannot be read, or whose states do not satisfy their constraints: a message for each.
class InputErrors : public std::runtime_error {
 public:
  explicit InputErrors(const std::vector<std::string>& messages);
  const std::vector<std::string>& messages() const { return messages_; }

 private:
  std::vector<std::string> messages_;
};

/// All of the scenes, whose states at time t must satisfy their constraints. Nothing can be computed and
/// lost: throws InputErrors about all that fail.
std::vector<NamedScene> load_consistent_scenes(const std::vector<std::string>& paths_or_names, double t);

/// Runs a program: what its input did wrong becomes exit code 2, what a solver could not do 3, each with its
/// message on stderr; see run_and_flush for what it printed.
int run_guarded(const std::function<int()>& program);

}  // namespace trivium
