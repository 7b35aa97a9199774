#include "base/gnuplot.hpp"

#include <cstdio>
#include <stdexcept>

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

void run_gnuplot(const std::string& script) {
  std::FILE* gnuplot = popen("gnuplot", "w");
  if (!gnuplot) throw std::runtime_error("gnuplot could not be started");
  std::fputs(script.c_str(), gnuplot);
  if (pclose(gnuplot) != 0)
    throw std::runtime_error("gnuplot failed; is it installed (Debian: gnuplot-nox)?");
}

}  // namespace trivium
