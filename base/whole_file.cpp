#include "base/whole_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <iterator>
#include <random>
#include <utility>

namespace trivium {

namespace fs = std::filesystem;

std::optional<fs::path> file_to_write(fs::path path) {
  std::error_code error;
  const fs::file_status found = fs::status(path, error);
  if (fs::exists(found) && !fs::is_regular_file(found)) return {};
  constexpr int most_links = 40;  // the limit of Linux for nested symbolic links
  for (int links = 0; fs::is_symlink(path, error); ++links) {
    if (links == most_links) return {};
    path = path.parent_path() / fs::read_symlink(path, error);
  }
  return path;
}

GrowingFile::GrowingFile(fs::path target) : target_(std::move(target)), temporary_(target_) {
  std::random_device random;
  temporary_ += fmt::format(".{:08x}{:08x}.tmp", random(), random());
  errno = 0;
  file_.open(temporary_, std::ios::binary);
}

GrowingFile::~GrowingFile() {
  std::error_code ignored;
  if (!is_kept_) fs::remove(temporary_, ignored);
}

std::error_code GrowingFile::keep() {
  file_.close();
  std::error_code reason;
  if (!file_)
    reason = {errno != 0 ? errno : EIO, std::generic_category()};
  else
    fs::rename(temporary_, target_, reason);
  is_kept_ = !reason;
  return reason;
}

std::error_code replace_file(const fs::path& target, std::string_view text) {
  GrowingFile file(target);
  file.write(text);
  return file.keep();
}

namespace {

[[noreturn]] void fail(const char* what, const fs::path& file, std::error_code reason) {
  throw fs::filesystem_error(what, file, reason);
}

}  // namespace

std::string read_whole(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in || fs::is_directory(file)) fail("cannot read", file, std::make_error_code(std::errc::io_error));
  return text;
}

void write_whole(const fs::path& file, std::string_view text) {
  const std::optional<fs::path> target = file_to_write(file);
  if (!target) fail("not a regular file", file, std::make_error_code(std::errc::invalid_argument));
  if (const std::error_code reason = replace_file(*target, text)) fail("cannot write", file, reason);
}

}  // namespace trivium
