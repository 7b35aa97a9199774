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
#include <utility>

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

/// A file that grows beside `target`, under a name that no other writer uses and on the same file system, and
/// takes its place when it is kept: until then the target stays as it was.
class GrowingFile {
 public:
  explicit GrowingFile(std::filesystem::path target) : target_(std::move(target)), temporary_(target_) {
    std::random_device random;
    temporary_ += fmt::format(".{:08x}{:08x}.tmp", random(), random());
    errno = 0;
    file_.open(temporary_, std::ios::binary);
  }
  GrowingFile(const GrowingFile&) = delete;
  ~GrowingFile() {
    std::error_code ignored;
    if (!is_kept_) std::filesystem::remove(temporary_, ignored);
  }

  void write(std::string_view text) { file_.write(text.data(), static_cast<std::streamsize>(text.size())); }
  /// Says why it could not be kept.
  std::error_code keep() {
    file_.close();
    std::error_code reason;
    if (!file_)
      reason = {errno != 0 ? errno : EIO, std::generic_category()};
    else
      std::filesystem::rename(temporary_, target_, reason);
    is_kept_ = !reason;
    return reason;
  }

 private:
  std::filesystem::path target_, temporary_;
  std::ofstream file_;
  bool is_kept_ = false;
};

/// The target has all of the text or stays as it was. Says why it could not be written.
inline std::error_code replace_file(const std::filesystem::path& target, std::string_view text) {
  GrowingFile file(target);
  file.write(text);
  return file.keep();
}

}  // namespace trivium
