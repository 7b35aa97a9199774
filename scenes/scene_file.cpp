#include "scenes/scene_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <random>
#include <system_error>

#include "scenes/json.hpp"
#include "scenes/scene_checks.hpp"
#include "scenes/scene_reader.hpp"

namespace trivium::scenes {
namespace {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
  const Path root(path.native());
  std::error_code error;
  if (fs::is_directory(path, error)) fail(root, "a folder", "a scene file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(root, fmt::format("cannot be read: {}", std::strerror(errno)), "a scene file");
  std::string text;
  char block[1 << 16];
  while (file.read(block, sizeof block) || file.gcount() > 0) {
    text.append(block, static_cast<std::size_t>(file.gcount()));
    if (text.size() > largest_file) break;  // the parser says so
  }
  if (file.bad()) fail(root, "cannot be read to its end", "a scene file");
  return text;
}

/// A name beside `path` that no other writer uses, so that renaming stays within one file system.
fs::path temporary_beside(const fs::path& path) {
  std::random_device random;
  fs::path temporary = path;
  temporary += fmt::format(".{:08x}{:08x}.tmp", random(), random());
  return temporary;
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

Scene read_scene_file(const fs::path& path) { return parse_scene(read_text(path), path.native()); }

void write_scene_file(const fs::path& path, const Scene& scene) {
  const std::string text = write_scene(scene);
  const Path root(path.native());
  std::error_code error;
  // A link stays a link; a device or a folder is not replaced by a file.
  const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
  if (fs::exists(target, error) && !fs::is_regular_file(target, error))
    fail(root, "not a regular file", "a file to write");
  const fs::path temporary = temporary_beside(target);
  errno = 0;
  std::ofstream file(temporary, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  std::string reason = file ? "" : std::strerror(errno);
  if (file) {
    fs::rename(temporary, target, error);
    if (error) reason = error.message();
  }
  if (!reason.empty()) {
    fs::remove(temporary, error);
    fail(root, "cannot be written: " + reason, "a file to write");
  }
}

}  // namespace trivium::scenes
