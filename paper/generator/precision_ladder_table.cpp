/// One line for each scene: the difference in every precision, and the largest difference in units of u
/// kappa.

#include "paper/generator/statistics.hpp"
#include "paper/generator/table.hpp"

namespace trivium::paper {

namespace {

struct Scalar {
  const char *name, *heading, *macro;
};
constexpr Scalar scalars[] = {{"float", "float", "Float"},
                              {"double", "double", "Double"},
                              {"long double", "long double", "LongDouble"},
                              {"quad", "quad", "Quad"},
                              {"50 digits", "50 digits", "Fifty"}};

/// The statistics of one precision over all scenes.
struct PrecisionResult {
  Sample difference, ratio, u, bound;
};

}  // namespace

std::string precision_ladder_table(Results& results, Numbers& numbers) {
  const ResultsTable& table = results["precision_ladder"];
  constexpr std::size_t rungs = std::size(scalars);
  if (table.rows.size() % rungs != 0) throw ResultsError("precision_ladder: a scene lacks a precision");
  std::vector<TexColumn> columns{{"l", {"scene"}}, {"r", {"$n_b$"}}, {condition, {"$\\kappa$"}}};
  for (const Scalar& scalar : scalars) columns.push_back({scientific, text(scalar.heading)});
  columns.push_back({"S[table-format=2.3]", {"worst$/(u\\kappa)$"}});
  TexTable out(columns);

  std::vector<PrecisionResult> all(rungs);
  std::size_t falling = 0, compared = 0, failed = 0;
  Sample worst_ratio;
  for (std::size_t first = 0; first < table.rows.size(); first += rungs) {
    const std::string& scene = table.text(first, "scene");
    std::vector<Tex> cells{text(scene), text(table.text(first, "nb")), number(table.number(first, "kappa"))};
    Sample ratios;
    bool falls = true;
    double previous = 1;
    for (std::size_t k = 0; k < rungs; ++k) {
      const std::size_t row = first + k;
      if (table.text(row, "scalar") != scalars[k].name || table.text(row, "scene") != scene)
        throw ResultsError("precision_ladder: the precisions of " + scene + " are out of order");
      cells.push_back(number_or_text(table.text(row, "difference")));
      const std::string& verdict = table.text(row, "verdict");
      if (verdict != "ok" && verdict != "none") ++failed;
      all[k].u.add(table.number(row, "u"));
      all[k].bound.add(table.number(row, "bound"));
      if (verdict == "none" || verdict == "ERROR") continue;
      const double difference = table.number(row, "difference");
      falls = falls && difference < previous;
      previous = difference;
      all[k].difference.add(difference, scene);
      const double in_u_kappa = difference / (table.number(row, "u") * table.number(row, "kappa"));
      ratios.add(in_u_kappa);
      all[k].ratio.add(in_u_kappa, scene);
      if (scene == "heavy_top")
        numbers.define(std::string("HeavyTop") + scalars[k].macro, ratio_in_text(in_u_kappa));
    }
    if (ratios.size() == 0) {
      cells.push_back(text("none"));
    } else {
      ++compared;
      if (falls) ++falling;
      worst_ratio.add(ratios.worst(), scene);
      cells.push_back(ratio(ratios.worst()));
    }
    out.add(cells);
  }
  for (std::size_t k = 0; k < rungs; ++k) {
    const std::string macro = std::string("Ladder") + scalars[k].macro;
    numbers.define(macro + "U", in_text(all[k].u.worst()));
    numbers.define(macro + "Median", in_text(all[k].difference.median()));
    numbers.define(macro + "RatioMedian", ratio_in_text(all[k].ratio.median()));
  }
  numbers.define("LadderFiftyFloor", power_of_ten_in_text(all.back().bound.least()));
  numbers.define("LadderFloatWorst", in_text(all.front().difference.worst()));
  numbers.define("LadderFiftyWorst", in_text(all.back().difference.worst()));
  numbers.define("LadderFiftyWorstScene", text(all.back().difference.worst_name()));
  numbers.define("LadderCompared", integer(compared));
  numbers.define("LadderFalling", integer(falling));
  numbers.define("LadderFailed", integer(failed));
  numbers.define("LadderPrecisions", integer(rungs));
  numbers.define("LadderRatioWorst", ratio_in_text(worst_ratio.worst()));
  numbers.define("LadderRatioWorstScene", text(worst_ratio.worst_name()));
  return out.str("results/precision_ladder.csv");
}

}  // namespace trivium::paper
