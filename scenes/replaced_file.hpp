#pragma once
/// Files that programs write: whole or not at all, and nothing but regular files. Header-only, so that what
/// writes results does without the library.

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <string_view>
#include <system_error>

namespace trivium {

/// The file that writing to `path` replaces: a link stays a link, and what it points to is written. Nothing
/// where that is there and no regular file: a device, a FIFO or a folder is not replaced by a file.
inline std::optional<std::filesystem::path> file_to_write(std::filesystem::path path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status found = fs::status(path, error);
  if (fs::exists(found) && !fs::is_regular_file(found)) return {};
  constexpr int most_links = 40;  // as many as Linux follows
  for (int links = 0; fs::is_symlink(path, error); ++links) {
    if (links == most_links) return {};
    path = path.parent_path() / fs::read_symlink(path, error);
  }
  return path;
}

/// Writes the text beside `target`, in a file that no other writer uses and on the same file system, and
/// renames it: the target has all of the text or stays as it was. Says why it could not.
inline std::error_code replace_file(const std::filesystem::path& target, std::string_view text) {
  namespace fs = std::filesystem;
  std::random_device random;
  fs::path temporary = target;
  temporary += fmt::format(".{:08x}{:08x}.tmp", random(), random());
  errno = 0;
  std::ofstream file(temporary, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  std::error_code reason, ignored;
  if (!file)
    reason = {errno != 0 ? errno : EIO, std::generic_category()};
  else
    fs::rename(temporary, target, reason);
  if (reason) fs::remove(temporary, ignored);
  return reason;
}

}  // namespace trivium
