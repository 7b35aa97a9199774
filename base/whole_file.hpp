#pragma once
/// Files read whole, and written whole or not at all. Decides which paths may be written: a regular file or
/// none yet, also through links; a device, a FIFO or a folder is never replaced.

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace trivium {

/// The file that writing to `path` replaces: a link stays a link, and what it points to is written. Nothing
/// where that is there and no regular file: a device, a FIFO or a folder is not replaced by a file.
std::optional<std::filesystem::path> file_to_write(std::filesystem::path path);

/// A file that grows beside `target`, under a name that no other writer uses and on the same file system, and
/// takes its place when it is kept: until then the target stays as it was.
class GrowingFile {
 public:
  explicit GrowingFile(std::filesystem::path target);
  GrowingFile(const GrowingFile&) = delete;
  ~GrowingFile();

  void write(std::string_view text) { file_.write(text.data(), static_cast<std::streamsize>(text.size())); }
  /// Says why it could not be kept.
  std::error_code keep();

 private:
  std::filesystem::path target_, temporary_;
  std::ofstream file_;
  bool is_kept_ = false;
};

/// The target has all of the text or stays as it was. Says why it could not be written.
std::error_code replace_file(const std::filesystem::path& target, std::string_view text);

/// Throws std::filesystem::filesystem_error.
std::string read_whole(const std::filesystem::path& file);

/// The file has all of the text or stays as it was; see file_to_write for what is a file. Throws
/// std::filesystem::filesystem_error.
void write_whole(const std::filesystem::path& file, std::string_view text);

}  // namespace trivium
