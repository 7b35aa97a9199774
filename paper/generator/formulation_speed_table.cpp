/// One line for each scene and method: microseconds per step in r-omega, and the ratios of the other
/// formulations.

#include <fmt/format.h>

#include "paper/generator/formulations.hpp"
#include "paper/generator/statistics.hpp"
#include "paper/generator/table.hpp"

namespace trivium::paper {

std::string formulation_speed_table(Results& results, Numbers& numbers) {
  const ResultsTable& table = results["formulation_speed"];
  const std::vector<std::string> formulations = formulations_of(table);
  const std::size_t n = formulations.size();
  const std::string two_digits = "S[table-format=2.2]";
  std::vector<TexColumn> columns{{"l", {"scene"}}, {"l", {"method"}}};
  columns.push_back(
      {"S[table-format=3.1]", {heading(formulations.front()).source + " [\\unit{\\micro\\second}]"}});
  for (std::size_t k = 1; k < n; ++k) columns.push_back({two_digits, heading(formulations[k])});
  for (const std::string& formulation : formulations) columns.push_back({two_digits, heading(formulation)});
  TexTable out(columns);
  out.head({fmt::format(
      "& & \\multicolumn{{{}}}{{c}}{{time of a step}} & \\multicolumn{{{}}}{{c}}{{iterations}} \\\\", n, n)});
  Sample rp, reps, rp_first, rp_fourth;  // ratios to the first formulation, r-omega
  std::string last;
  for (std::size_t first = 0; first < table.rows.size(); first += n) {
    const std::string &scene = table.text(first, "scene"), &method = table.text(first, "method");
    if (!last.empty() && scene != last) out.rule();
    for (std::size_t k = 0; k < n; ++k)
      if (table.text(first + k, "formulation") != formulations[k] ||
          table.text(first + k, "method") != method)
        throw ResultsError("formulation_speed: the rows of " + scene + " are out of order");
    std::vector<Tex> cells{text(scene == last ? "" : scene), text(method),
                           ratio(table.number(first, "us_per_step"))};
    for (std::size_t k = 1; k < n; ++k) cells.push_back(ratio(table.number(first + k, "ratio")));
    last = scene;
    for (std::size_t k = 0; k < n; ++k)
      cells.push_back(ratio(table.number(first + k, "iterations_per_step")));
    out.add(cells);
    for (std::size_t k = 0; k < n; ++k) {
      const double beside = table.number(first + k, "ratio");
      if (formulations[k] == "r-epsilon") reps.add(beside, scene);
      if (formulations[k] != "r-p") continue;
      rp.add(beside, scene);
      if (method.starts_with("bdf1")) rp_first.add(beside);
      if (method.starts_with("bdf4")) rp_fourth.add(beside);
    }
  }
  numbers.define("SpeedRpMedian", ratio_in_text(rp.median()));
  numbers.define("SpeedRpLeast", ratio_in_text(rp.least()));
  numbers.define("SpeedRpWorst", ratio_in_text(rp.worst()));
  numbers.define("SpeedRepsMedian", ratio_in_text(reps.median()));
  numbers.define("SpeedRepsLeast", ratio_in_text(reps.least()));
  numbers.define("SpeedRepsWorst", ratio_in_text(reps.worst()));
  numbers.define("SpeedRpFirstOrder", ratio_in_text(rp_first.median()));
  numbers.define("SpeedRpFourthOrder", ratio_in_text(rp_fourth.median()));
  return out.str("results/formulation_speed.csv");
}

}  // namespace trivium::paper
