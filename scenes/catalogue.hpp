#pragma once
/// Scenes by name or path: the catalogue that comes with the project, and files beside it. Decided here:
/// where the catalogue is looked for, and that a file's path comes before a name.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace trivium {

/// The folder of the catalogue: $TRIVIUM_SCENES, else share/trivium/scenes beside the installed program, else
/// the source tree's.
std::filesystem::path catalogue_directory();

/// All scene files of the catalogue, sorted by name.
std::vector<std::filesystem::path> catalogue();

/// The scene of a path as given, its state at t (scenes::time_of), or of the catalogue's scene of that name,
/// which no folder of the same name hides. Throws scenes::SceneError.
scenes::Scene load_scene(const std::string& path_or_name, std::optional<double> t = {});

}  // namespace trivium
