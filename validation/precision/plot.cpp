/// Writes the script and the data of a figure for gnuplot: curves of the runs that succeeded, crosses for
/// those that failed.

#include "validation/precision/plot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "base/gnuplot.hpp"

namespace trivium::precision {

namespace {

/// The runs of one method as a curve.
struct Curve {
  std::string name, points;
  bool is_peer;
  std::vector<std::string> failed_at;  ///< gnuplot positions of the crosses that mark failed runs

  Curve(const SceneResult& result, const RunSettings& method)
      : name(who(method)), is_peer(precision::is_peer(method)) {
    for (const RunResult& o : result.runs) {
      if (who(o.settings) != name) continue;
      // a position on the first (lower) axis, or 98 % of the width of the graph
      if (!o.solved()) {
        failed_at.push_back(o.settings.rtol ? fmt::format("first {:.0e}", *o.settings.rtol) : "graph 0.98");
      } else if (o.errors.position > result.reference_error) {
        points += fmt::format("{:.3e} {:.5g} {:.5g} {:.5g}\n", o.errors.position, o.seconds.median,
                              o.seconds.low, o.seconds.high);
      }
    }
  }
};

/// Point type and dash type, as numbers of gnuplot.
struct LineStyle {
  int points, dashes;
};
constexpr std::array<LineStyle, 3> lines_of_ours{{{7, 1}, {9, 4}, {13, 3}}},
    lines_of_peers{{{4, 2}, {8, 5}, {6, 2}}};

}  // namespace

void plot(const SceneResult& result, const std::filesystem::path& folder) {
  std::vector<Curve> curves;
  for (const RunResult& o : result.runs) {
    const bool is_shown = is_peer(o.settings) || o.settings.formulation == "r-omega";
    const auto is_its = [&](const Curve& curve) { return curve.name == who(o.settings); };
    if (is_shown && std::none_of(curves.begin(), curves.end(), is_its))
      curves.emplace_back(result, o.settings);
  }
  std::string data, crosses;
  std::vector<std::string> lines;
  int rows_of_crosses = 0;
  std::size_t peers = 0;
  for (std::size_t n = 0; n < curves.size(); ++n) {
    const Curve& curve = curves[n];
    // gnuplot has eight colours by default; after these, the next point and dash types
    const std::size_t among_its_kind = curve.is_peer ? peers++ : n - peers;
    const std::size_t color = among_its_kind % 8 + 1;
    const LineStyle style = (curve.is_peer ? lines_of_peers : lines_of_ours)[among_its_kind / 8 % 3];
    if (!curve.points.empty()) data += fmt::format("$m{} << EOD\n{}EOD\n", n, curve.points);
    // a separate row of crosses for each curve, so that none hides another
    if (!curve.failed_at.empty()) ++rows_of_crosses;
    for (const std::string& at : curve.failed_at)
      crosses += fmt::format("set label '' at {}, graph {:.3f} point pt 2 ps 0.6 lc {}\n", at,
                             0.015 * rows_of_crosses, color);
    const std::string counted = curve.failed_at.empty()
                                    ? curve.name
                                    : fmt::format("{} ({} failed)", curve.name, curve.failed_at.size());
    lines.push_back(fmt::format("{} with yerrorlines lw 1.5 pt {} ps 0.5 lc {} dt {} title {}",
                                curve.points.empty() ? "keyentry" : fmt::format("$m{} using 1:2:3:4", n),
                                style.points, color, style.dashes, gnuplot_quoted(counted)));
  }
  for (const auto& [terminal, suffix] :
       {std::pair("svg size 900,650 noenhanced font 'sans,11' background '#ffffff'", ".svg"),
        {"pdfcairo size 16cm,11.5cm noenhanced font 'sans,9'", ".pdf"}}) {
    const std::filesystem::path figure = folder / (result.scene + suffix);
    run_gnuplot(
        fmt::format(
            "{}{}set terminal {}\nset output {}\nset title {}\nset grid\nset logscale xy\nset format '%.0e'\n"
            "set xlabel 'error of positions [m]; crosses: runs that failed, at their tolerance'\n"
            "set ylabel 'CPU time [s]'\nset key outside right\nplot {}\n",
            data, crosses, terminal, gnuplot_quoted(figure.string()),
            gnuplot_quoted(fmt::format("{}, {} s", result.scene, result.t_end)),
            fmt::join(lines, ", \\\n  ")),
        figure);
  }
}

}  // namespace trivium::precision
