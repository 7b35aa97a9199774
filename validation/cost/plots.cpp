#include "validation/cost/plots.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

namespace trivium::cost {

namespace {

/// What gnuplot would take for the end of a string or an escape.
std::string in_quotes(std::string_view s) {
  std::string out = "'";
  for (const char c : s) out += c == '\'' ? std::string("''") : std::string(1, c);
  return out + "'";
}

std::string label(const Measurement& row) {
  std::string text = row.engine;
  if (row.ours) text += " " + row.formulation + (row.refinement == "refined" ? ", refined" : "");
  return text;
}

std::string script(const std::vector<Measurement>& rows, const std::string& family, const std::string& title,
                   const std::filesystem::path& file) {
  std::map<std::string, std::string> data;
  std::vector<std::string> order;
  std::set<int> sizes;
  for (const Measurement& row : rows) {
    if (row.family != family || !row.microseconds) continue;
    sizes.insert(row.n);
    std::string& lines = data[label(row)];
    if (lines.empty()) order.push_back(label(row));
    lines += fmt::format("{} {}\n", row.n, row.microseconds_per_body());
  }
  if (sizes.size() < 2) return {};
  std::string blocks, curves;
  for (std::size_t k = 0; k < order.size(); ++k) {
    blocks += fmt::format("$d{} << EOD\n{}EOD\n", k, data[order[k]]);
    curves += fmt::format("{}$d{} using 1:2 with linespoints lw {} pt {} title {}", k == 0 ? "" : ", \\\n  ",
                          k, order[k].starts_with(our_name) ? 2.5 : 1.2, k + 1, in_quotes(order[k]));
  }
  return fmt::format(
      "set terminal svg size 900,560 noenhanced font 'sans,12' background '#ffffff'\nset output {}\n"
      "set title {}\nset logscale xy\nset grid\nset key outside right\nset xlabel 'n'\n"
      "set ylabel 'microseconds per body and evaluation'\n{}plot {}\n",
      in_quotes(file.string()), in_quotes(title), blocks, curves);
}

void run_gnuplot(const std::string& text) {
  if (text.empty()) return;
  std::FILE* gnuplot = popen("gnuplot", "w");
  if (!gnuplot) throw std::runtime_error("gnuplot could not be started");
  std::fputs(text.c_str(), gnuplot);
  if (pclose(gnuplot) != 0) throw std::runtime_error("gnuplot failed (Debian: gnuplot-nox)");
}

}  // namespace

void write_plots(const std::vector<Measurement>& rows, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  run_gnuplot(script(rows, "chain", "W1: chain of n revolutes", folder / "chain.svg"));
  run_gnuplot(script(rows, "ladder", "W3: ladder of n four-bar loops", folder / "ladder.svg"));
}

}  // namespace trivium::cost
