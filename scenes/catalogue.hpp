#pragma once
/// Loads scenes by name or by path. A name refers to the catalogue, the folder of scene files that comes with
/// the project. This file decides where the catalogue is looked for, and that an existing file comes before a
/// name.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace trivium {

/// The folder of the catalogue: $TRIVIUM_SCENES if set. Otherwise it is share/trivium/scenes in the
/// installation of the running program, or in the installation to which `header` belongs. If neither exists,
/// it is the folder in the source tree. `header` is the path PREFIX/include/trivium/NAME.hpp of an installed
/// header; trivium/scene.hpp passes its own path by __FILE__. Without a header only the running program
/// counts.
std::filesystem::path catalogue_directory(const std::filesystem::path& header = {});

/// The paths of all scene files of the catalogue, sorted; `header` as in catalogue_directory(). Throws
/// scenes::SceneError if there is no such folder.
std::vector<std::filesystem::path> catalogue(const std::filesystem::path& header = {});

/// The scene in the file at this path, or the scene of the catalogue with this name. A folder of the same
/// name does not hide a scene of the catalogue. The scene is checked at time t [s] (scenes::time_of).
/// `header` as in catalogue_directory(). Throws scenes::SceneError.
scenes::Scene load_scene(const std::string& path_or_name, std::optional<double> t = {},
                         const std::filesystem::path& header = {});

}  // namespace trivium
