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

/// A file that replaces `target` when `keep` is called; without `keep` it is deleted. Until then it is called
/// `target`.incomplete-N with the number N of the process. A process that is killed leaves it under this
/// name. The file is in the folder of `target`, hence on the same file system, so that the replacement is one
/// atomic rename.
class GrowingFile {
 public:
  explicit GrowingFile(std::filesystem::path target);
  GrowingFile(const GrowingFile&) = delete;
  ~GrowingFile();

  /// Returns false if this or an earlier text could not be written.
  bool write(std::string_view text);
  /// Closes the file and renames it to `target`. Returns the reason if that failed; the file then stays,
  /// with its whole lines, as `incomplete()`, if it could be made at all.
  std::error_code keep();
  const std::filesystem::path& incomplete() const { return temporary_; }

 private:
  void note_failure();
  void cut_to_whole_lines();

  std::filesystem::path target_, temporary_;
  std::ofstream file_;
  std::error_code reason_;  ///< why a text could not be written
  bool stays_ = false;
};

/// Replaces `target` by a file with the given text, or leaves it unchanged and returns the reason.
std::error_code replace_file(const std::filesystem::path& target, std::string_view text);

/// The content of `file`. Throws std::filesystem::filesystem_error if it cannot be read.
std::string read_whole(const std::filesystem::path& file);

/// Writes the file that file_to_write(file) names. Throws std::filesystem::filesystem_error if it names none
/// or if writing fails; an old file is then unchanged.
void write_whole(const std::filesystem::path& file, std::string_view text);

}  // namespace trivium
