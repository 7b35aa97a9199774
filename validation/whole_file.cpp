#include "validation/whole_file.hpp"

#include <fstream>
#include <iterator>

namespace trivium {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const char* what, const fs::path& file) {
  throw fs::filesystem_error(what, file, std::make_error_code(std::errc::io_error));
}

}  // namespace

std::string read_whole(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in || fs::is_directory(file)) fail("cannot read", file);
  return text;
}

void write_whole(const fs::path& file, std::string_view text) {
  const fs::path partial = fs::path(file).concat(".partial");
  {
    std::ofstream out(partial, std::ios::binary);
    out << text;
    out.flush();
    if (!out) {
      std::error_code ignored;
      fs::remove(partial, ignored);
      fail("cannot write", file);
    }
  }
  fs::rename(partial, file);
}

}  // namespace trivium
