/// One line a scene and method: microseconds a step in r-omega, and what the others take beside it.

#include "paper/generator/statistics.hpp"
#include "paper/generator/table.hpp"

namespace trivium::paper {

std::string formulation_speed_table(Results& results, Numbers& numbers) {
  const ResultsTable& table = results["formulation_speed"];
  const std::vector<std::string> formulations{"r-omega", "r-p", "r-epsilon"};
  const std::size_t n = formulations.size();
  if (table.rows.size() % n != 0) throw ResultsError("formulation_speed: a method lacks a formulation");
  const std::string two_digits = "S[table-format=2.2]";
  TexTable out({{"l", {"scene"}},
                {"l", {"method"}},
                {"S[table-format=3.1]", {"\\romega [\\unit{\\micro\\second}]"}},
                {two_digits, {"\\rp"}},
                {two_digits, {"\\reps"}},
                {two_digits, {"\\romega"}},
                {two_digits, {"\\rp"}},
                {two_digits, {"\\reps"}}});
  out.head({"& & \\multicolumn{3}{c}{time of a step} & \\multicolumn{3}{c}{iterations} \\\\"});
  Sample rp, reps, rp_first, rp_fourth;
  std::string last;
  for (std::size_t first = 0; first < table.rows.size(); first += n) {
    const std::string &scene = table.text(first, "scene"), &method = table.text(first, "method");
    if (!last.empty() && scene != last) out.rule();
    for (std::size_t k = 0; k < n; ++k)
      if (table.text(first + k, "formulation") != formulations[k] ||
          table.text(first + k, "method") != method)
        throw ResultsError("formulation_speed: the rows of " + scene + " are out of order");
    std::vector<Tex> cells{text(scene == last ? "" : scene), text(method),
                           ratio(table.number(first, "us_per_step")), ratio(table.number(first + 1, "ratio")),
                           ratio(table.number(first + 2, "ratio"))};
    last = scene;
    for (std::size_t k = 0; k < n; ++k)
      cells.push_back(ratio(table.number(first + k, "iterations_per_step")));
    out.add(cells);
    rp.add(table.number(first + 1, "ratio"), scene);
    reps.add(table.number(first + 2, "ratio"), scene);
    if (method.starts_with("bdf1")) rp_first.add(table.number(first + 1, "ratio"));
    if (method.starts_with("bdf4")) rp_fourth.add(table.number(first + 1, "ratio"));
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
