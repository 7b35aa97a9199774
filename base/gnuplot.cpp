#include "base/gnuplot.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>
#include <system_error>

#include "base/whole_file.hpp"

namespace trivium {

std::string gnuplot_quoted(std::string_view s) {
  std::string out = "'";
  for (const char c : s) {
    // A newline ends a gnuplot string even inside quotes; other control characters do not belong in a title.
    // Outside single quotes gnuplot executes text between backquotes as a shell command; without backquotes a
    // title is safe even there.
    const bool ends_a_string = static_cast<unsigned char>(c) < ' ' || c == 0x7f;
    out += c == '\'' ? std::string("''") : std::string(1, ends_a_string || c == '`' ? ' ' : c);
  }
  return out + "'";
}

void run_gnuplot(const std::string& script, const std::filesystem::path& figure) {
  std::FILE* gnuplot = popen("gnuplot", "w");
  if (!gnuplot) throw std::runtime_error("gnuplot could not be started");
  std::fputs(script.c_str(), gnuplot);
  if (pclose(gnuplot) != 0)
    throw std::runtime_error("gnuplot failed; is it installed (Debian: gnuplot-nox)?");
  std::error_code ignored;
  const std::string drawn = std::filesystem::exists(figure, ignored) ? read_whole(figure) : "";
  for (const char* end : {"</svg>", "%%EOF"})  // of SVG and of PDF
    if (drawn.find(end) != std::string::npos) return;
  std::filesystem::remove(figure, ignored);
  throw std::runtime_error(
      fmt::format("cannot write {}: the figure is incomplete; is the disk full?", figure.string()));
}

}  // namespace trivium
