#include "validation/cost/plots.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <string>

#include "base/gnuplot.hpp"

namespace trivium::cost {

namespace {

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
                          k, order[k].starts_with(our_name) ? 2.5 : 1.2, k + 1, gnuplot_quoted(order[k]));
  }
  return fmt::format(
      "set terminal svg size 900,560 noenhanced font 'sans,12' background '#ffffff'\nset output {}\n"
      "set title {}\nset logscale xy\nset grid\nset key outside right\nset xlabel 'n'\n"
      "set ylabel 'microseconds per body and evaluation'\n{}plot {}\n",
      gnuplot_quoted(file.string()), gnuplot_quoted(title), blocks, curves);
}

}  // namespace

void write_plots(const std::vector<Measurement>& rows, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const auto plot = [&](const char* family, const char* title, const char* file) {
    const std::string text = script(rows, family, title, folder / file);
    if (!text.empty()) run_gnuplot(text, folder / file);
  };
  plot("chain", "chain of n revolutes", "chain.svg");
  plot("ladder", "ladder of n four-bar loops", "ladder.svg");
}

}  // namespace trivium::cost
