#include "validation/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "bodies/error.hpp"
#include "formulations/assembly.hpp"
#include "results/standard_output.hpp"
#include "scenes/scene_file.hpp"

namespace trivium {

namespace fs = std::filesystem;

fs::path catalogue_directory() {
  if (const char* from_environment = std::getenv("TRIVIUM_SCENES")) return from_environment;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    const fs::path installed = program.parent_path().parent_path() / "share" / "trivium" / "scenes";
    if (fs::is_directory(installed)) return installed;
  }
  return TRIVIUM_SOURCE_SCENES;
}

std::string reference_directory() {
  if (const char* from_environment = std::getenv("TRIVIUM_REFERENCE")) return from_environment;
  const fs::path installed = catalogue_directory().parent_path() / "reference";
  return fs::is_directory(installed) ? installed.string() : TRIVIUM_SOURCE_REFERENCE;
}

std::vector<fs::path> catalogue() {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(catalogue_directory()))
    if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".schema")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

namespace {

/// No file and no scene of the catalogue; the nearest of its names is suggested.
[[noreturn]] void throw_unknown_scene(const std::string& name) {
  std::vector<std::string> names;
  std::error_code error;
  if (fs::is_directory(catalogue_directory(), error))
    for (const fs::path& file : catalogue()) names.push_back(file.stem().string());
  const fs::path asked(name);
  throw scenes::SceneError(name.empty() ? "\"\"" : name, "",
                           "no such file, and no such scene in the catalogue",
                           "a path to a scene file, or a name that trivium list prints",
                           scenes::nearest(asked.extension() == ".json" ? asked.stem().string() : name,
                                           {names.begin(), names.end()}));
}

}  // namespace

scenes::Scene load_scene(const std::string& path_or_name, double t) {
  std::error_code error;
  const bool is_there = fs::exists(path_or_name, error);
  if (path_or_name.find('/') == std::string::npos && (!is_there || fs::is_directory(path_or_name, error))) {
    const fs::path by_name = catalogue_directory() / (path_or_name + ".json");
    if (fs::exists(by_name, error)) return scenes::read_scene_file(by_name, t);
    if (!is_there) throw_unknown_scene(path_or_name);
  }
  return scenes::read_scene_file(path_or_name, t);
}

InputErrors::InputErrors(const std::vector<std::string>& messages)
    : std::runtime_error(fmt::format("{}", fmt::join(messages, "\n"))), messages_(messages) {}

namespace {

/// What of its constraints a scene's state does not satisfy; empty where it satisfies all.
std::string inconsistency(const NamedScene& named, double t) {
  try {
    const Consistency consistency =
        check_consistency(make_mechanism<double>(named.scene), make_state<double>(named.scene, t));
    if (consistency.holds()) return {};
    std::string report = consistency.report();
    report.erase(report.find_last_not_of('\n') + 1);
    return fmt::format("{}: the state at t = {} does not satisfy its constraints:\n{}", named.source, t,
                       report);
  } catch (const ModelError&) {
    return {};  // no equations at this state: the solver says so, and of this scene alone
  }
}

}  // namespace

std::vector<NamedScene> load_consistent_scenes(const std::vector<std::string>& paths_or_names, double t) {
  std::vector<NamedScene> scenes;
  std::vector<std::string> messages;
  for (const std::string& source : paths_or_names) {
    try {
      NamedScene named{source, load_scene(source, t)};
      const std::string message = inconsistency(named, t);
      if (message.empty())
        scenes.push_back(std::move(named));
      else
        messages.push_back(message);
    } catch (const scenes::SceneError& error) {
      messages.emplace_back(error.what());
    }
  }
  if (!messages.empty()) throw InputErrors(messages);
  return scenes;
}

int run_guarded(const std::function<int()>& program) {
  return run_and_flush([&]() -> int {
    try {
      return program();
    } catch (const scenes::SceneError& error) {
      complain(error.what());
      return exit_input_error;
    } catch (const InputErrors& errors) {
      for (const std::string& message : errors.messages()) complain(message);
      return exit_input_error;
    } catch (const ModelError& error) {
      complain(error.what());
      return exit_solver_failed;
    } catch (const fs::filesystem_error& error) {
      complain(error.what());
      return exit_input_error;
    }
  });
}

}  // namespace trivium
