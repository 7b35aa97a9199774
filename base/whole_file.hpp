#pragma once
/// Reads whole files and replaces files atomically: a written file has either all of its new content or its
/// old one. A path may be written if it names a regular file, directly or through symbolic links, or a file
/// that does not exist yet. Devices, FIFOs and folders are never replaced.

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace trivium {

/// The file that a write to `path` replaces: the target of the link if `path` is a symbolic link, otherwise
/// `path`. None if this file is a device, a FIFO or a folder, or if the links form a cycle.
std::optional<std::filesystem::path> file_to_write(std::filesystem::path path);

/// A temporary file that replaces `target` when `keep` is called; without `keep` it is deleted. The file is
/// in the folder of `target`, hence on the same file system, so that the replacement is one atomic rename. A
/// random suffix separates it from the temporary files of other writers.
class GrowingFile {
 public:
  explicit GrowingFile(std::filesystem::path target);
  GrowingFile(const GrowingFile&) = delete;
  ~GrowingFile();

  void write(std::string_view text) { file_.write(text.data(), static_cast<std::streamsize>(text.size())); }
  /// Closes the file and renames it to `target`. Returns the reason if that failed.
  std::error_code keep();

 private:
  std::filesystem::path target_, temporary_;
  std::ofstream file_;
  bool is_kept_ = false;
};

/// Replaces `target` by a file with the given text, or leaves it unchanged and returns the reason.
std::error_code replace_file(const std::filesystem::path& target, std::string_view text);

/// The content of `file`. Throws std::filesystem::filesystem_error if it cannot be read.
std::string read_whole(const std::filesystem::path& file);

/// Replaces the file that file_to_write(file) names. Throws std::filesystem::filesystem_error if there is no
/// such file or if it cannot be written; the old file is then unchanged.
void write_whole(const std::filesystem::path& file, std::string_view text);

}  // namespace trivium
