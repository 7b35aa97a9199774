#pragma once
/// Runs the project's programs as a user does. Also makes faulty scenes for them. Only tests include this.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace trivium::test {

namespace fs = std::filesystem;
using nlohmann::json;

struct Outcome {
  int exit_code = -1;
  std::string out, err;
};

inline std::string slurp(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A temporary file whose name contains that of the current test, because tests run in parallel.
inline fs::path temporary(const std::string& name) {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  return fs::path(testing::TempDir()) /
         (std::string(test.test_suite_name()) + "." + test.name() + "." + name);
}

/// The same, after a file left by an earlier run is removed.
inline fs::path fresh(const std::string& name) {
  fs::remove(temporary(name));
  return temporary(name);
}

/// Runs a program of the project with arguments, such as "trivium list"; in `folder` if it is not empty.
inline Outcome run(const std::string& words, const fs::path& folder = {}) {
  const std::string there = folder.empty() ? "" : "cd " + folder.string() + " && ";
  const fs::path errors = temporary("err");
  FILE* pipe = popen((there + TRIVIUM_BIN "/" + words + " 2>" + errors.string()).c_str(), "r");
  Outcome result;
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    result.out.append(buffer.data(), n);
  result.exit_code = WEXITSTATUS(pclose(pipe));
  result.err = slurp(errors);
  return result;
}

inline std::string temporary_scene(const std::string& name, const std::string& text) {
  const fs::path file = temporary(name);
  std::ofstream(file) << text;
  return file.string();
}

/// The names of the validation programs of this build.
inline std::vector<std::string> validations() {
  std::istringstream list(TRIVIUM_VALIDATIONS);
  std::vector<std::string> names;
  for (std::string name; list >> name;) names.push_back(name);
  return names;
}

/// A scene on a wrong branch: the two axes of its revolute joint point in opposite directions.
inline std::string hung_backwards() {
  return temporary_scene("hung_backwards.json", R"({"trivium": 1, "name": "hung_backwards",
    "bodies": [{"name": "flap", "mass": 1, "inertia": [1, 1, 1], "position": [0, 0, 0]}],
    "constraints": [{"type": "revolute", "name": "hinge", "i": {"body": "ground", "axis": [0, 0, 1]},
                     "j": {"body": "flap", "axis": [0, 0, -1]}}]})");
}

/// A consistent scene without accelerations: a bead between two rods moves across them, and each rod demands
/// an acceleration towards its own side.
inline std::string dead_point() {
  return temporary_scene("dead_point.json", R"({"trivium": 1, "name": "bead_between_rods",
    "bodies": [{"name": "bead", "mass": 1, "inertia": [1, 1, 1], "position": [0, 0, 0], "velocity": [0, 1, 0]}],
    "constraints": [
      {"type": "distance", "name": "left", "i": {"body": "ground", "point": [-1, 0, 0]}, "j": {"body": "bead"}, "distance": 1},
      {"type": "distance", "name": "right", "i": {"body": "ground", "point": [1, 0, 0]}, "j": {"body": "bead"}, "distance": 1}]})");
}

/// The simple pendulum with a velocity that violates its joint.
inline std::string moving_wrongly() {
  std::string text = slurp(TRIVIUM_SCENES_DIR "/simple_pendulum.json");
  const std::size_t at = text.find("\"velocity\": [") + 13;
  text.replace(at, text.find(']', at) - at, "1, 2, 3");
  return temporary_scene("moving_wrongly.json", text);
}

inline const json& formulation(const json& solution, const std::string& name) {
  for (const json& f : solution["formulations"])
    if (f["name"] == name) return f;
  throw std::out_of_range(name);
}

}  // namespace trivium::test
