#pragma once
/// Reads and writes scene files (scene format, version 1). A scene that was read has finite numbers, physical
/// bodies and no dangling names. A scene that was written reads back as the same scene, double for double
/// (except rank_tolerance, which files do not have): Euler parameters and axes are not normalised here.
/// Limits: 64 MiB, 100 000 bodies, 10 million values, 64 levels of nesting; tolerances and magnitudes are in
/// scene_checks.hpp.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "scenes/format/scene_error.hpp"
#include "scenes/scene.hpp"

namespace trivium::scenes {

/// Reads a scene. Throws a SceneError, and no other exception, if the file is not a valid scene. Functions of
/// time must be finite at t = 0 and at the time of the state (time_of).
Scene read_scene_file(const std::filesystem::path& path, std::optional<double> t = {});
/// Reads a scene from the text of a file. `file_name` is the name for messages. Functions of time are checked
/// at t = 0 only, and not for jumps (check_functions in scene_checks.hpp). Throws a SceneError.
Scene parse_scene(std::string_view text, std::string_view file_name);

/// The text of the scene's file: keys in the order of the format, defaults omitted. Throws a SceneError if
/// check_scene or check_magnitudes refuses the scene.
std::string write_scene(const Scene& scene);
/// Writes the file completely or not at all.
void write_scene_file(const std::filesystem::path& path, const Scene& scene);

}  // namespace trivium::scenes
