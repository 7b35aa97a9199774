/// One line for each scene: the differences of accelerations, lambda and reactions, for each way of
/// rebuilding the scene in Simbody. A dagger marks a comparison with the physical twin; "none" marks a way
/// that is not possible.

#include <map>
#include <set>

#include "paper/generator/statistics.hpp"
#include "paper/generator/table.hpp"

namespace trivium::paper {

namespace {

const std::vector<std::string> ways{"mobilizers", "free bodies", "built-in"};
const std::vector<std::string> quantities{"acceleration", "lambda", "reaction"};

/// A group of columns for each way, with a narrow last column for the dagger.
TexTable empty_table() {
  std::vector<TexColumn> columns{{"l", {"scene"}}};
  for (std::size_t k = 0; k < ways.size(); ++k) {
    columns.push_back({scientific, {"accel."}});
    columns.push_back({scientific, {"$\\lambda$"}});
    columns.push_back({scientific, {"reaction"}});
    columns.push_back({"@{}l", {}});
  }
  TexTable out(columns);
  out.head(
      {"& \\multicolumn{3}{c}{mobilizers} && \\multicolumn{3}{c}{free bodies, custom rows} && "
       "\\multicolumn{3}{c}{free bodies, built-in rows} \\\\"});
  out.head({"\\cmidrule(lr){2-4} \\cmidrule(lr){6-8} \\cmidrule(lr){10-12}"});
  return out;
}

}  // namespace

std::string simbody_reference_table(Results& results, Numbers& numbers) {
  const ResultsTable& table = results["simbody_reference"];
  if (table.rows.size() % ways.size() != 0) throw ResultsError("simbody_reference: a scene lacks a way");
  TexTable out = empty_table();
  std::map<std::string, Sample> distance;
  Sample bound, defect;
  std::set<std::string> twin_scenes;
  std::size_t comparisons = 0, agreeing = 0, twins = 0, mobilized = 0, idle = 0;
  for (std::size_t first = 0; first < table.rows.size(); first += ways.size()) {
    const std::string& scene = table.text(first, "scene");
    std::vector<Tex> cells{text(scene)};
    for (std::size_t w = 0; w < ways.size(); ++w) {
      const std::size_t row = first + w;
      if (table.text(row, "way") != ways[w] || table.text(row, "scene") != scene)
        throw ResultsError("simbody_reference: the ways of " + scene + " are out of order");
      const bool twin = table.text(row, "twin") == "yes";
      for (const std::string& quantity : quantities) {
        const std::string& cell = table.text(row, quantity);
        cells.push_back(number_or_text(cell));
        if (cell != "none") distance[quantity].add(table.number(row, quantity), scene);
      }
      cells.push_back({twin ? "\\twin" : ""});
      if (twin) ++twins, twin_scenes.insert(scene);
      if (table.text(row, "verdict") == "none") continue;
      ++comparisons;
      if (table.text(row, "verdict") == "agrees") ++agreeing;
      bound.add(table.number(row, "bound"), scene);
      defect.add(table.number(row, "pose_defect"), scene);
      idle += static_cast<std::size_t>(table.number(row, "idle_rows"));
      if (w == 0 && table.number(row, "mobilizers") > 0) ++mobilized;
    }
    out.add(cells);
  }
  for (const auto& [quantity, macro] :
       {std::pair{"acceleration", "SimbodyAcceleration"}, std::pair{"lambda", "SimbodyLambda"},
        std::pair{"reaction", "SimbodyReaction"}}) {
    numbers.define(std::string(macro) + "Median", in_text(distance[quantity].median()));
    numbers.define(std::string(macro) + "Worst", in_text(distance[quantity].worst()));
  }
  numbers.define("SimbodyLambdaWorstScene", text(distance["lambda"].worst_name()));
  numbers.define("SimbodyScenes", integer(table.rows.size() / ways.size()));
  numbers.define("SimbodyComparisons", integer(comparisons));
  numbers.define("SimbodyAgreeing", integer(agreeing));
  numbers.define("SimbodyTwins", integer(twins));
  numbers.define("SimbodyTwinScenes", integer(twin_scenes.size()));
  numbers.define("SimbodyMobilized", integer(mobilized));
  numbers.define("SimbodyIdleRows", integer(idle));
  numbers.define("SimbodyPoseDefect", in_text(defect.worst()));
  numbers.define("SimbodyFloor", power_of_ten_in_text(bound.least()));
  return out.str("results/simbody_reference.csv");
}

}  // namespace trivium::paper
