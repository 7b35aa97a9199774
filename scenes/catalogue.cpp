#include "scenes/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "scenes/format/scene_file.hpp"

namespace trivium {

namespace fs = std::filesystem;

namespace {

/// The scene files of a folder, sorted.
std::vector<fs::path> scene_files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

fs::path catalogue_directory(const fs::path& header) {
  if (const char* from_environment = std::getenv("TRIVIUM_SCENES")) return from_environment;
  std::error_code error;
  // the prefixes of PREFIX/bin/program and of PREFIX/include/trivium/header.hpp
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  for (const fs::path& prefix :
       {program.parent_path().parent_path(), header.parent_path().parent_path().parent_path()})
    if (const fs::path installed = prefix / "share" / "trivium" / "scenes";
        !prefix.empty() && fs::is_directory(installed, error))
      return installed;
  return TRIVIUM_SOURCE_SCENES;
}

std::vector<fs::path> catalogue(const fs::path& header) {
  const fs::path folder = catalogue_directory(header);
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw scenes::SceneError(
        folder.string(), "", "the folder of the catalogue does not exist",
        "an installation with share/trivium/scenes, or the environment variable TRIVIUM_SCENES");
  return scene_files_in(folder);
}

namespace {

/// Throws the SceneError for a name that is neither a file nor a scene of the catalogue. The message suggests
/// the nearest name of the catalogue.
[[noreturn]] void throw_unknown_scene(const std::string& name, const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  if (fs::is_directory(folder, error))
    for (const fs::path& file : scene_files_in(folder)) names.push_back(file.stem().string());
  const fs::path asked(name);
  throw scenes::SceneError(name.empty() ? "\"\"" : name, "",
                           "no such file, and no such scene in the catalogue",
                           "a path to a scene file, or a name that trivium list prints",
                           scenes::nearest(asked.extension() == ".json" ? asked.stem().string() : name,
                                           {names.begin(), names.end()}));
}

}  // namespace

scenes::Scene load_scene(const std::string& path_or_name, std::optional<double> t, const fs::path& header) {
  std::error_code error;
  const bool is_there = fs::exists(path_or_name, error);
  if (path_or_name.find('/') == std::string::npos && (!is_there || fs::is_directory(path_or_name, error))) {
    const fs::path folder = catalogue_directory(header), by_name = folder / (path_or_name + ".json");
    if (fs::exists(by_name, error)) return scenes::read_scene_file(by_name, t);
    if (!is_there) throw_unknown_scene(path_or_name, folder);
  }
  return scenes::read_scene_file(path_or_name, t);
}

}  // namespace trivium
