/// One line for each scene of the catalogue, and the median and worst values of the random mechanisms.

#include <cmath>

#include "base/raise.hpp"
#include "paper/generator/formulations.hpp"
#include "paper/generator/statistics.hpp"
#include "paper/generator/table.hpp"

namespace trivium::paper {

namespace {

/// The columns that compare two formulations; their names contain a slash.
std::vector<std::string> pairs_of(const ResultsTable& table) {
  std::vector<std::string> pairs;
  for (const std::string& column : table.columns)
    if (column.find('/') != std::string::npos) pairs.push_back(column);
  return pairs;
}

Tex heading_of_pair(const std::string& pair) {
  const std::size_t slash = pair.find('/');
  return {heading(pair.substr(0, slash)).source + "/" + heading(pair.substr(slash + 1)).source};
}

bool is_random(const std::string& scene) { return scene.starts_with("random_"); }

/// The statistics of one group of rows.
struct Group {
  explicit Group(const std::vector<std::string>& all_pairs) : pairs(all_pairs), difference(pairs.size()) {}

  const std::vector<std::string> pairs;
  Sample kappa, worst, ratio, bodies, rows;  ///< ratio: the largest difference divided by u kappa
  std::vector<Sample> difference;
  std::size_t count = 0, failed = 0, unconstrained = 0, ambiguous = 0, cancels = 0;

  void add(const ResultsTable& table, std::size_t row, double bound_factor) {
    ++count;
    const std::string& scene = table.text(row, "scene");
    const std::string& verdict = table.text(row, "verdict");
    const double nc = table.number(row, "nc");
    bodies.add(table.number(row, "nb"), scene);
    rows.add(nc, scene);
    if (verdict == "none") {
      ++(nc == 0 ? unconstrained : ambiguous);
      return;
    }
    if (verdict == "EXCEEDS" || verdict == "ERROR") ++failed;
    if (verdict == "cancels") ++cancels;
    if (verdict == "ERROR") return;
    kappa.add(table.number(row, "kappa"), scene);
    double largest = 0;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      difference[k].add(table.number(row, pairs[k]), scene);
      raise(largest, table.number(row, pairs[k]));
    }
    worst.add(largest, scene);
    ratio.add(bound_factor * largest / table.number(row, "bound"), scene);
  }

  /// Defines the numbers that the text quotes for a group.
  void define(Numbers& numbers, const std::string& prefix) const {
    numbers.define(prefix + "Count", integer(count));
    numbers.define(prefix + "Compared", integer(worst.size()));
    numbers.define(prefix + "Failed", integer(failed));
    numbers.define(prefix + "Cancels", integer(cancels));
    numbers.define(prefix + "MostBodies", whole(bodies.worst()));
    numbers.define(prefix + "KappaWorst", in_text(kappa.worst()));
    numbers.define(prefix + "Median", in_text(worst.median()));
    numbers.define(prefix + "Worst", in_text(worst.worst()));
    numbers.define(prefix + "RatioMedian", ratio_in_text(ratio.median()));
    numbers.define(prefix + "RatioWorst", ratio_in_text(ratio.worst()));
  }
  static Tex whole(double n) { return integer(static_cast<std::size_t>(n)); }
};

std::vector<Tex> summary_row(const std::string& name, const Group& g, double (Sample::*statistic)() const) {
  std::vector<Tex> cells{text(name), {}, {}, {}, number((g.kappa.*statistic)())};
  for (const Sample& sample : g.difference) cells.push_back(number((sample.*statistic)()));
  cells.push_back({});
  return cells;
}

/// The factor bound / (u kappa), from a row of the precision ladder, which states u.
double bound_factor(const ResultsTable& ladder) {
  for (std::size_t k = 0; k < ladder.rows.size(); ++k)
    if (ladder.text(k, "scalar") == "double")
      return std::round(ladder.number(k, "bound") / (ladder.number(k, "u") * ladder.number(k, "kappa")));
  throw ResultsError("precision_ladder: no row in double");
}

}  // namespace

std::string lambda_invariance_table(Results& results, Numbers& numbers) {
  const ResultsTable& table = results["lambda_invariance"];
  const double factor = bound_factor(results["precision_ladder"]);
  const std::vector<std::string> pairs = pairs_of(table);
  std::vector<TexColumn> columns{
      {"l", {"scene"}}, {"r", {"$n_b$"}}, {"r", {"$n_c$"}}, {"r", {"rank"}}, {condition, {"$\\kappa$"}}};
  for (const std::string& pair : pairs) columns.push_back({scientific, heading_of_pair(pair)});
  columns.push_back({scientific, {"bound"}});
  TexTable out(columns);
  Group scenes(pairs), random(pairs);
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const std::string& scene = table.text(k, "scene");
    const bool failed = table.text(k, "verdict") == "EXCEEDS" || table.text(k, "verdict") == "ERROR";
    (is_random(scene) ? random : scenes).add(table, k, factor);
    if (is_random(scene) && !failed) continue;
    std::vector<Tex> cells{text(scene), text(table.text(k, "nb")), text(table.text(k, "nc")),
                           text(table.text(k, "rank")), number_or_text(table.text(k, "kappa"))};
    for (const std::string& pair : pairs) cells.push_back(number_or_text(table.text(k, pair)));
    cells.push_back(number_or_text(table.text(k, "bound")));
    out.add(cells);
    if (scene == "heavy_top") {
      const double u_kappa = table.number(k, "bound") / factor;
      numbers.define("HeavyTopRPRatio", ratio_in_text(table.number(k, "r-omega/r-p") / u_kappa));
      numbers.define("HeavyTopREpsilonRatio", ratio_in_text(table.number(k, "r-omega/r-epsilon") / u_kappa));
    }
  }
  out.rule();
  const std::string name = std::to_string(random.count) + " random: ";
  out.add(summary_row(name + "median", random, &Sample::median));
  out.add(summary_row(name + "worst", random, &Sample::worst));
  scenes.define(numbers, "Scene");
  numbers.define("SceneUnconstrained", integer(scenes.unconstrained));
  numbers.define("SceneAmbiguous", integer(scenes.ambiguous));
  numbers.define("SceneMostRows", Group::whole(scenes.rows.worst()));
  numbers.define("SceneWorstScene", text(scenes.worst.worst_name()));
  numbers.define("SceneRatioWorstScene", text(scenes.ratio.worst_name()));
  random.define(numbers, "Random");
  numbers.define("BoundFactor", ratio_in_text(factor));
  return out.str("results/lambda_invariance.csv");
}

}  // namespace trivium::paper
