/// simbody_reference: are our accelerations, multipliers and reactions Simbody's? Every scene is rebuilt in
/// Simbody as a tree of mobilizers, as free bodies with one custom constraint a row, and as free bodies with
/// Simbody's own constraints, and compared with every formulation.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "validation/catalogue.hpp"
#include "validation/progress.hpp"
#include "validation/results_file.hpp"
#include "validation/simbody_comparison.hpp"
#include "validation/text_output.hpp"

namespace trivium {

namespace {

struct Arguments {
  std::vector<std::string> scenes;
  double t = 0;
  bool json = false;
  std::string csv;
};

std::string verdict_of(const SimbodyComparison& c) {
  if (!c.solved()) return "not solved";
  return c.agrees() ? "agrees" : "DIFFERS";
}

std::string way_of(const SimbodyComparison& c) {
  return std::string(name_of(c.way)) + (c.twin ? ", twin" : "");
}

std::string table(const std::vector<SimbodyComparison>& comparisons) {
  Table table({"scene", "way", "nb", "nc", "rank", "mobilizers", "rows", "idle", "kappa", "acceleration",
               "lambda", "reaction", "bound", "verdict"});
  const auto small = [](double x) { return fmt::format("{:.1e}", x); };
  for (const SimbodyComparison& c : comparisons) {
    const SimbodyDistance d = c.worst();
    table.add({c.scene, way_of(c), fmt::format("{}", c.nb), fmt::format("{}", c.nc),
               fmt::format("{}", c.rank), fmt::format("{}", c.mobilizers),
               fmt::format("{}", c.constraint_rows), fmt::format("{}", c.idle_rows), small(c.kappa),
               small(d.acceleration), c.any_unique ? small(d.lambda) : "none",
               c.any_constraint ? small(d.reaction) : "none", small(c.bound()), verdict_of(c)});
  }
  return table.text();
}

/// What Simbody refused, one line each.
std::string refusals(const std::vector<SimbodyComparison>& comparisons) {
  std::string out;
  for (const SimbodyComparison& c : comparisons)
    if (c.twin)
      out += fmt::format("{}, {}: Simbody refuses the scene, its physical twin is compared: {}\n", c.scene,
                         name_of(c.way), c.refusal);
  return out.empty() ? out : "\n" + out;
}

/// What could not be compared, one line each.
std::string failures(const std::vector<SimbodyComparison>& comparisons) {
  std::string out;
  for (const SimbodyComparison& c : comparisons) {
    if (!c.failure.empty())
      out += fmt::format("error: {}, {}: Simbody refuses the twin: {}\n", c.scene, name_of(c.way), c.failure);
    for (const SimbodyDistance& d : c.formulations)
      if (!d.error.empty())
        out += fmt::format("error: {}: {}: not solved: {}\n", c.scene, d.formulation, d.error);
  }
  return out;
}

std::string json(const Arguments& arguments, const std::vector<SimbodyComparison>& comparisons) {
  JsonWriter json;
  json.begin_object().number("t", arguments.t).begin_array("comparisons");
  for (const SimbodyComparison& c : comparisons) {
    json.begin_object()
        .text("scene", c.scene)
        .text("way", name_of(c.way))
        .flag("twin", c.twin)
        .number("nb", c.nb)
        .number("nc", c.nc)
        .number("rank", c.rank)
        .number("mobilizers", c.mobilizers)
        .number("constraint_rows", c.constraint_rows)
        .number("idle_rows", c.idle_rows)
        .number("kappa", c.kappa)
        .number("pose_defect", c.pose_defect)
        .number("bound", c.bound())
        .text("verdict", verdict_of(c))
        .text("refusal", c.refusal)
        .text("failure", c.failure);
    json.begin_array("formulations");
    for (const SimbodyDistance& d : c.formulations) {
      json.begin_object().text("name", d.formulation);
      if (!d.error.empty()) {
        json.text("error", d.error);
      } else {
        json.number("acceleration", d.acceleration);
        if (c.any_unique) json.number("lambda", d.lambda);
        if (c.any_constraint) json.number("reaction", d.reaction);
      }
      json.end_object();
    }
    json.end_array().end_object();
  }
  return json.end_array().end_object().str();
}

/// One row a scene and way.
ResultsFile results(const std::vector<SimbodyComparison>& comparisons) {
  ResultsFile file(
      "simbody_reference",
      {"scene", "way", "twin", "nb", "nc", "rank", "mobilizers", "constraint_rows", "idle_rows", "kappa",
       "pose_defect", "acceleration", "lambda", "reaction", "bound", "verdict", "refusal"});
  for (const SimbodyComparison& c : comparisons) {
    const SimbodyDistance d = c.worst();
    const auto number_if = [&](bool known, double x) {
      return known && c.solved() ? results_number(x) : std::string("none");
    };
    file.add({c.scene, std::string(name_of(c.way)), c.twin ? "yes" : "no", std::to_string(c.nb),
              std::to_string(c.nc), std::to_string(c.rank), std::to_string(c.mobilizers),
              std::to_string(c.constraint_rows), std::to_string(c.idle_rows), results_number(c.kappa),
              results_number(c.pose_defect), number_if(true, d.acceleration),
              number_if(c.any_unique, d.lambda), number_if(c.any_constraint, d.reaction),
              results_number(c.bound()), verdict_of(c), c.refusal});
  }
  return file;
}

int run(const Arguments& arguments, int argc, char** argv) {
  std::vector<std::string> paths = arguments.scenes;
  if (paths.empty())
    for (const auto& path : catalogue()) paths.push_back(path.string());
  std::vector<scenes::Scene> scenes;
  for (const std::string& path : paths) scenes.push_back(load_consistent_scene(path, arguments.t));

  std::vector<SimbodyComparison> comparisons;
  {
    Progress progress("simbody_reference", scenes.size());
    for (const scenes::Scene& scene : scenes) {
      for (SimbodyComparison& c : compare_with_simbody(scene, arguments.t))
        comparisons.push_back(std::move(c));
      progress.step();
    }
  }
  if (!arguments.csv.empty()) results(comparisons).write(arguments.csv, argc, argv);
  fmt::print(stderr, "{}", failures(comparisons));
  fmt::print("{}",
             arguments.json ? json(arguments, comparisons) : table(comparisons) + refusals(comparisons));

  const auto all = [&](auto is) { return std::all_of(comparisons.begin(), comparisons.end(), is); };
  if (!all([](const SimbodyComparison& c) { return c.solved(); })) return exit_solver_failed;
  return all([](const SimbodyComparison& c) { return c.agrees(); }) ? exit_done : exit_criterion_failed;
}

}  // namespace

}  // namespace trivium

int main(int argc, char** argv) {
  using namespace trivium;
  CLI::App app{"Accelerations, multipliers and reactions of scenes against Simbody", "simbody_reference"};
  Arguments arguments;
  app.set_version_flag("--version", "trivium " TRIVIUM_VERSION);
  app.add_option("SCENE", arguments.scenes, "Scene files or catalogue names (default: the whole catalogue)");
  app.add_option("--time", arguments.t, "The time of the scenes' states [s]");
  app.add_flag("--json", arguments.json, "JSON on stdout");
  app.add_option("--csv", arguments.csv, "Write the table to this CSV file, and a manifest beside it");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_done : exit_input_error;
  }
  return run_guarded([&] { return run(arguments, argc, argv); });
}
