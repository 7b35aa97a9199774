#include "base/whole_file.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <cerrno>
#include <iterator>
#include <new>
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
  temporary_ += fmt::format(".incomplete-{}", getpid());
  errno = 0;
  try {
    file_.open(temporary_, std::ios::binary);
  } catch (const std::bad_alloc&) {  // of the buffer, after the file has been made
    std::error_code ignored;
    fs::remove(temporary_, ignored);
    throw;
  }
  note_failure();
}

GrowingFile::~GrowingFile() {
  std::error_code ignored;
  if (!stays_) fs::remove(temporary_, ignored);
}

void GrowingFile::note_failure() {
  if (!file_ && !reason_) reason_ = {errno != 0 ? errno : EIO, std::generic_category()};
}

bool GrowingFile::write(std::string_view text) {
  errno = 0;
  file_.write(text.data(), static_cast<std::streamsize>(text.size()));
  note_failure();
  return !reason_;
}

std::error_code GrowingFile::keep() {
  errno = 0;
  file_.close();
  note_failure();
  if (!reason_) fs::rename(temporary_, target_, reason_);
  stays_ = true;
  if (reason_) cut_to_whole_lines();
  return reason_;
}

void GrowingFile::cut_to_whole_lines() {
  std::error_code failed;
  if (!fs::exists(temporary_, failed)) return;
  const std::string written = read_whole(temporary_);
  fs::resize_file(temporary_, written.find_last_of('\n') + 1, failed);  // npos + 1 is 0
}

std::error_code replace_file(const fs::path& target, std::string_view text) {
  GrowingFile file(target);
  file.write(text);
  const std::error_code reason = file.keep();
  std::error_code ignored;
  if (reason) fs::remove(file.incomplete(), ignored);  // the caller still has the text
  return reason;
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
