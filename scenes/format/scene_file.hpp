#pragma once
/// Scenes in and out of files (scene format, version 1). What is read is finite, physical and free of
/// dangling names; what is written reads back as the same scene, double for double. Numbers stay as the file
/// states them: Euler parameters and axes are not normalised here. Limits: 64 MiB, 100 000 bodies, 10 million
/// values, 64 levels of nesting; tolerances and magnitudes stand in scene_checks.hpp.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "scenes/format/scene_error.hpp"
#include "scenes/scene.hpp"

namespace trivium::scenes {

/// Throws SceneError, and nothing else, for what is not a scene; its functions of time must be finite
/// at the time of its state too (time_of).
Scene read_scene_file(const std::filesystem::path& path, std::optional<double> t = {});
Scene parse_scene(std::string_view text, std::string_view file_name);

/// The scene as its file would have it: keys in the order of the format, defaults left out. Throws SceneError
/// for what could not be read again.
std::string write_scene(const Scene& scene);
/// The file appears whole or not at all.
void write_scene_file(const std::filesystem::path& path, const Scene& scene);

}  // namespace trivium::scenes
