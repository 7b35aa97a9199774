#pragma once
/// Draws plots by running gnuplot (Debian: gnuplot-nox). Names come from scene files, so they are quoted so
/// that none of them is a command to gnuplot.

#include <string>
#include <string_view>

namespace trivium {

/// A string as gnuplot takes it, whatever is in it: control characters and backquotes become blanks.
std::string gnuplot_quoted(std::string_view s);

/// Runs a script. Throws a std::runtime_error where gnuplot is not there or fails.
void run_gnuplot(const std::string& script);

}  // namespace trivium
