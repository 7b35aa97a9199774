#include "results/whole_file.hpp"

#include <fstream>
#include <iterator>

#include "scenes/replaced_file.hpp"

namespace trivium {

namespace fs = std::filesystem;

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
