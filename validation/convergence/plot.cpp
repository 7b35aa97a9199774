/// Writes the script and the data of a figure for gnuplot, with one panel for each of the four quantities.

#include "validation/convergence/plot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "base/gnuplot.hpp"

namespace trivium::convergence {

void plot(const std::vector<OrderResult>& rows, const std::string& scene, const std::string& formulation,
          const std::string& file) {
  std::string data;
  std::array<std::vector<std::string>, 4> curves;
  std::array<std::map<int, std::array<double, 2>>, 4> lowest;  // by order: end of its lowest curve
  for (const OrderResult& row : rows) {
    if (row.scene != scene || row.formulation != formulation || !row.solved()) continue;
    const std::size_t n = curves[0].size() + 1;
    data += fmt::format("$m{} << EOD\n", n);
    for (std::size_t level = 0; level < row.h.size(); ++level)
      data += fmt::format("{:.9g} {:.3e}\n", row.h[level], fmt::join(row.errors[level], " "));
    data += "EOD\n";
    for (int k = 0; k < 4; ++k) {
      curves[k].push_back(row.has(k)
                              ? fmt::format("$m{} using 1:{} with linespoints lw 1.5 pt 7 ps 0.6 lc {} dt {} "
                                            "title {}",
                                            n, k + 2, n % 8 + 1, n / 8 + 1, gnuplot_quoted(row.of.label))
                              : "");
      if (!row.has(k)) continue;
      auto& low = lowest[k]
                      .try_emplace(row.published(k), std::array{row.h.back(), row.errors.back()[k]})
                      .first->second;
      if (row.errors.back()[k] < low[1]) low = {row.h.back(), row.errors.back()[k]};
    }
  }
  std::string panels;
  for (int k = 0; k < 4; ++k) {
    std::erase(curves[k], "");
    panels += "unset object\nunset label\n";
    int n = 0;
    for (const auto& [order, from] : lowest[k]) {
      // a triangle below the curve: to the right by a factor 1.7 in h, upwards by 1.7^order
      const double h = from[0], wide = 1.7 * h, low = from[1] / 4, high = low * std::pow(1.7, order);
      panels += fmt::format(
          "set object {0} polygon from {1:.5g},{2:.5g} to {3:.5g},{2:.5g} to {3:.5g},{4:.5g} to "
          "{1:.5g},{2:.5g} "
          "fillstyle empty border lc 'gray40'\nset label {0} '{5}' at {6:.5g},{7:.5g} textcolor 'gray40'\n",
          ++n, h, low, wide, high, order, 1.05 * wide, std::sqrt(low * high));
    }
    panels +=
        fmt::format("set ylabel {}\nplot {}\n", gnuplot_quoted(std::string("error of ") + quantities[k]),
                    fmt::join(curves[k], ", \\\n  "));
  }
  run_gnuplot(
      fmt::format(
          "{}set terminal svg size 1500,1000 noenhanced font 'sans,11' background '#ffffff'\nset output {}\n"
          "set multiplot layout 2,2 title {}\nset grid\nset logscale xy\nset format '%.0e'\nset xlabel 'h "
          "[s]'\n"
          "set key outside right top font ',9'\n{}unset multiplot\n",
          data, gnuplot_quoted(file), gnuplot_quoted(fmt::format("{}, {}", scene, formulation)), panels),
      file);
}

}  // namespace trivium::convergence
