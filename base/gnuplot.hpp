#pragma once
/// Runs gnuplot (Debian: gnuplot-nox) to draw plots. Titles contain names from scene files, so they are
/// quoted to prevent a name from acting as a gnuplot command.

#include <filesystem>
#include <string>
#include <string_view>

namespace trivium {

/// `s` as a single-quoted gnuplot string. Control characters and backquotes become blanks.
std::string gnuplot_quoted(std::string_view s);

/// Runs a gnuplot script that draws the SVG or PDF file `figure`. Throws std::runtime_error if gnuplot is
/// missing or fails, or if the figure is not whole: gnuplot itself does not notice a full disk. Such a file
/// is deleted.
void run_gnuplot(const std::string& script, const std::filesystem::path& figure);

}  // namespace trivium
