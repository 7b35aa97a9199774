/// One line for each scene and error: the cheapest run of Trivium and of Simbody that is at least as
/// accurate.

#include <optional>

#include "paper/generator/figure.hpp"
#include "paper/generator/statistics.hpp"
#include "paper/generator/table.hpp"
#include "results/tools/position_targets.hpp"

namespace trivium::paper {

namespace {

/// The cheapest run of a scene, by Trivium or by Simbody, whose error of positions is at most the target. The
/// reference solution must be ten times as accurate as the target.
std::optional<std::size_t> cheapest(const ResultsTable& table, const std::string& scene, double target,
                                    bool is_ours) {
  std::optional<std::size_t> best;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (table.text(row, "scene") != scene || table.text(row, "failure") != "none" ||
        (table.text(row, "engine") == "trivium") != is_ours ||
        table.number(row, "reference_error") > target / 10 || table.number(row, "position") > target)
      continue;
    if (!best || table.number(row, "median_ms") < table.number(*best, "median_ms")) best = row;
  }
  return best;
}

std::string who(const ResultsTable& table, std::size_t row) {
  const std::string& formulation = table.text(row, "formulation");
  return table.text(row, "method") + (formulation == "none" ? "" : ", " + formulation);
}

}  // namespace

std::string work_precision_table(Results& results, Numbers& numbers) {
  const ResultsTable& table = results["work_precision"];
  TexTable out({{"l", {"scene"}},
                {"S[table-format=1.1e-1]", {"error [\\unit{\\metre}]"}},
                {"l", {"our cheapest"}},
                {"S[table-format=3.2]", {"[\\unit{\\milli\\second}]"}},
                {"l", {"Simbody's cheapest"}},
                {"S[table-format=4.1]", {"[\\unit{\\milli\\second}]"}},
                {"S[table-format=3.1]", {"ratio"}}});
  std::vector<std::string> scenes;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    if (scenes.empty() || scenes.back() != table.text(row, "scene"))
      scenes.push_back(table.text(row, "scene"));
  Sample ratios;
  for (const std::string& scene : scenes)
    for (const double target : position_targets) {
      const auto ours = cheapest(table, scene, target, true), peer = cheapest(table, scene, target, false);
      const auto ms = [&](const auto& row) {
        return row ? ratio(table.number(*row, "median_ms")) : Tex{"--"};
      };
      const auto name = [&](const auto& row) { return row ? text(who(table, *row)) : Tex{"none"}; };
      Tex beside{"--"};
      if (ours && peer) {
        const double r = table.number(*peer, "median_ms") / table.number(*ours, "median_ms");
        ratios.add(r, scene);
        beside = ratio(r);
      }
      out.add({text(target == position_targets[0] ? scene : ""), number(target), name(ours), ms(ours),
               name(peer), ms(peer), beside});
    }
  numbers.define("WorkLeastRatio", ratio_in_text(ratios.least()));
  numbers.define("WorkMedianRatio", ratio_in_text(ratios.median()));
  numbers.define("WorkMostRatio", ratio_in_text(ratios.worst()));
  numbers.define("WorkMostRatioScene", text(ratios.worst_name()));
  numbers.define("WorkCompared", integer(ratios.size()));
  return out.str("results/work_precision.csv");
}

namespace {

/// A figure of time against error: Trivium's methods in r-omega solid, Simbody's methods dashed.
std::string costs(const ResultsTable& table, const std::string& scene, const std::vector<std::string>& ours) {
  LogLogFigure figure({"error of positions [\\unit{\\metre}]"}, {"CPU time [\\unit{\\milli\\second}]"});
  const auto add = [&](const std::string& method, const std::string& formulation, const std::string& name) {
    LogLogFigure::Points points;
    for (std::size_t row = 0; row < table.rows.size(); ++row)
      if (table.text(row, "scene") == scene && table.text(row, "method") == method &&
          table.text(row, "formulation") == formulation && table.text(row, "failure") == "none")
        points.emplace_back(table.text(row, "position"), table.text(row, "median_ms"));
    figure.add(text(name), points);
  };
  for (const std::string& method : ours) add(method, "r-omega", method);
  for (const auto& [method, name] : {std::pair("RungeKuttaMerson", "Merson"),
                                     {"RungeKuttaFeldberg", "Feldberg"},
                                     {"CPodes Adams", "CPodes Adams"},
                                     {"CPodes BDF", "CPodes BDF"}})
    add(method, "none", name);
  return figure.str("results/work_precision.csv");
}

}  // namespace

std::string work_on_two_bars_figure(Results& results, Numbers&) {
  return costs(results["work_precision"], "two_bars", {"rkf78", "bulirsch-stoer", "abm", "cvode-adams"});
}

std::string work_on_the_governor_figure(Results& results, Numbers&) {
  return costs(results["work_precision"], "flyball_governor", {"rkf78", "cvode-bdf", "radau5", "radau9"});
}

}  // namespace trivium::paper
