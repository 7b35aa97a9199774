/// The cost of one evaluation: a table over the scenes, and figures of time per body against n for chains and
/// ladders.

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "paper/generator/figure.hpp"
#include "paper/generator/formulations.hpp"
#include "paper/generator/table.hpp"

namespace trivium::paper {

namespace {

/// One solver of the table or the figures. The three texts select its rows in the results file.
struct Solver {
  std::string engine, formulation, refinement;
  Tex name;
};

const std::vector<Solver> others{{"Simbody 3.7", "none", "none", {"Simbody"}},
                                 {"MuJoCo 2.2.2", "none", "none", {"MuJoCo"}},
                                 {"DART 6.12", "none", "none", {"DART"}},
                                 {"SuiteSparse KLU", "r-omega", "none", {"KLU"}}};

/// The first formulation without refinement, and every formulation with refinement.
std::vector<Solver> ours(const ResultsTable& table) {
  std::vector<Solver> all;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const std::string &formulation = table.text(row, "formulation"),
                      &refinement = table.text(row, "refinement");
    const bool is_known = std::any_of(all.begin(), all.end(), [&](const Solver& one) {
      return one.formulation == formulation && one.refinement == refinement;
    });
    if (table.text(row, "engine") != "Trivium" || table.text(row, "scene") == "ensemble" || is_known)
      continue;
    const bool is_refined = refinement == "refined";
    if (all.empty() || is_refined)
      all.push_back({"Trivium",
                     formulation,
                     refinement,
                     {heading(formulation).source + (is_refined ? ", refined" : "")}});
  }
  return all;
}

std::vector<Solver> all_solvers(const ResultsTable& table) {
  std::vector<Solver> all = ours(table);
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

/// One scene and its rows in the results file.
struct SceneRows {
  std::string scene;
  std::vector<std::size_t> rows;
};

std::vector<SceneRows> scenes_of(const ResultsTable& table) {
  std::vector<SceneRows> all;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const std::string& scene = table.text(row, "scene");
    if (scene == "ensemble") continue;
    if (all.empty() || all.back().scene != scene) all.push_back({scene, {}});
    all.back().rows.push_back(row);
  }
  return all;
}

/// The row of a solver; empty if the solver has no time for this scene.
std::optional<std::size_t> row_of(const ResultsTable& table, const SceneRows& scene, const Solver& solver) {
  for (const std::size_t row : scene.rows)
    if (table.text(row, "engine") == solver.engine && table.text(row, "formulation") == solver.formulation &&
        table.text(row, "refinement") == solver.refinement && table.text(row, "microseconds") != "none")
      return row;
  return {};
}

/// A time without an exponent: two decimals below 10, one below 100, none above. The limits 9.995 and 99.95
/// are those at which rounding adds a digit.
Tex microseconds(double x) {
  const int digits = x < 9.995 ? 2 : x < 99.95 ? 1 : 0;
  return {fmt::format("{:.{}f}", x, digits)};
}

/// A figure of time per body for one family of scenes: Trivium's formulations solid, other engines dashed.
std::string plot(const ResultsTable& table, const std::string& family, const std::string& origin) {
  LogLogFigure figure({"$n$"}, {"microseconds per body"});
  for (const Solver& solver : all_solvers(table)) {
    LogLogFigure::Points points;
    for (const SceneRows& scene : scenes_of(table)) {
      if (!scene.scene.starts_with(family + "_")) continue;
      if (const auto row = row_of(table, scene, solver))
        points.emplace_back(table.text(*row, "n"), table.text(*row, "microseconds_per_body"));
    }
    figure.add(solver.name, points);
  }
  return figure.str(origin);
}

const std::string origin = "results/acceleration_cost.csv";

}  // namespace

std::string acceleration_cost_table(Results& results, Numbers& numbers) {
  const ResultsTable& table = results["acceleration_cost"];
  std::vector<TexColumn> columns{{"l", {"mechanism"}}, {"r", {"$n_b$"}}};
  const std::vector<Solver> all = all_solvers(table);
  for (const Solver& solver : all) columns.push_back({"r", solver.name});
  TexTable out(columns);
  for (const SceneRows& scene : scenes_of(table)) {
    std::vector<Tex> cells{text(scene.scene), text(table.text(scene.rows.front(), "bodies"))};
    for (const Solver& solver : all) {
      const auto row = row_of(table, scene, solver);
      cells.push_back(row ? microseconds(table.number(*row, "microseconds")) : Tex{"--"});
    }
    out.add(cells);
    if (scene.scene != "chain_100") continue;
    const auto time = [&](const Solver& solver) {
      const auto row = row_of(table, scene, solver);
      if (!row) throw ResultsError("acceleration_cost: chain_100 has no time of " + solver.engine);
      return table.number(*row, "microseconds");
    };
    const double own = time(all[0]), refined = time(all[1]);
    numbers.define("CostSimbody", ratio_in_text(time(others[0]) / own));
    numbers.define("CostSimbodyRefined", ratio_in_text(time(others[0]) / refined));
    numbers.define("CostMujoco", ratio_in_text(time(others[1]) / own));
    numbers.define("CostMujocoRefined", ratio_in_text(time(others[1]) / refined));
    numbers.define("CostDart", ratio_in_text(time(others[2]) / own));
    numbers.define("CostDartRefined", ratio_in_text(time(others[2]) / refined));
  }
  return out.str(origin);
}

std::string cost_of_chains_figure(Results& results, Numbers&) {
  return plot(results["acceleration_cost"], "chain", origin);
}

std::string cost_of_ladders_figure(Results& results, Numbers&) {
  return plot(results["acceleration_cost"], "ladder", origin);
}

}  // namespace trivium::paper
