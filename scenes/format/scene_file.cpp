#include "scenes/format/scene_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <new>
#include <system_error>

#include "base/whole_file.hpp"
#include "scenes/format/json.hpp"
#include "scenes/format/scene_checks.hpp"
#include "scenes/format/scene_reader.hpp"

namespace trivium::scenes {
namespace {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
  const Path root(path.native());
  std::error_code error;
  if (fs::is_directory(path, error)) fail(root, "a folder", "a scene file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file && errno == ENOMEM) throw std::bad_alloc();  // no fault of the file
  if (!file) fail(root, fmt::format("cannot be read: {}", std::strerror(errno)), "a scene file");
  std::string text;
  char block[1 << 16];
  while (file.read(block, sizeof block) || file.gcount() > 0) {
    text.append(block, static_cast<std::size_t>(file.gcount()));
    if (text.size() > largest_file) break;  // parse_json then reports that the file is too large
  }
  if (file.bad()) fail(root, "cannot be read to its end", "a scene file");
  return text;
}

}  // namespace

Scene parse_scene(std::string_view text, std::string_view file_name) {
  const Path root(file_name);
  if (text.find('\0') != std::string_view::npos) fail(root, "a NUL character", "a JSON document");
  const Json json = parse_json(text, root);
  check_magnitudes(json, root);
  Scene scene = read_scene(json, root);
  check_scene(scene, root);
  return scene;
}

Scene read_scene_file(const fs::path& path, std::optional<double> t) {
  Scene scene = parse_scene(read_text(path), path.native());
  check_functions(scene, time_of(scene, t), Path(path.native()));
  return scene;
}

void write_scene_file(const fs::path& path, const Scene& scene) {
  const std::string text = write_scene(scene);
  const Path root(path.native());
  const std::optional<fs::path> target = file_to_write(path);
  if (!target) fail(root, "not a regular file", "a file to write");
  if (const std::error_code reason = replace_file(*target, text))
    fail(root, "cannot be written: " + reason.message(), "a file to write");
}

}  // namespace trivium::scenes
