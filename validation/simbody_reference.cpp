/// simbody_reference: are our accelerations, multipliers and reactions Simbody's? Every scene is rebuilt in
/// Simbody as a tree of mobilizers, as free bodies with one custom constraint a row, and as free bodies with
/// Simbody's own constraints, and compared with every formulation.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>

#include "validation/catalogue.hpp"
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

std::string csv_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

/// One row a scene and way; an empty cell where there is nothing to compare.
std::string csv(const std::vector<SimbodyComparison>& comparisons) {
  std::string out =
      "scene,way,twin,nb,nc,rank,mobilizers,constraint_rows,idle_rows,kappa,pose_defect,acceleration,lambda,"
      "reaction,bound,verdict,refusal\n";
  for (const SimbodyComparison& c : comparisons) {
    const SimbodyDistance d = c.worst();
    const auto cell = [&](bool known, double x) {
      return known && c.solved() ? number_text(x) : std::string();
    };
    const std::vector<std::string> cells{csv_text(c.scene),
                                         csv_text(name_of(c.way)),
                                         number_text(c.twin ? 1.0 : 0.0),
                                         std::to_string(c.nb),
                                         std::to_string(c.nc),
                                         std::to_string(c.rank),
                                         std::to_string(c.mobilizers),
                                         std::to_string(c.constraint_rows),
                                         std::to_string(c.idle_rows),
                                         number_text(c.kappa),
                                         number_text(c.pose_defect),
                                         cell(true, d.acceleration),
                                         cell(c.any_unique, d.lambda),
                                         cell(c.any_constraint, d.reaction),
                                         number_text(c.bound()),
                                         verdict_of(c),
                                         csv_text(c.refusal)};
    out += fmt::format("{}\n", fmt::join(cells, ","));
  }
  return out;
}

int run(const Arguments& arguments) {
  std::ofstream csv_file;
  if (!arguments.csv.empty()) {  // before the work, so that a bad path costs nothing
    csv_file.open(arguments.csv);
    if (!csv_file) {
      fmt::print(stderr, "error: cannot write {}\n", arguments.csv);
      return exit_input_error;
    }
  }
  std::vector<std::string> paths = arguments.scenes;
  if (paths.empty())
    for (const auto& path : catalogue()) paths.push_back(path.string());
  std::vector<scenes::Scene> scenes;
  for (const std::string& path : paths) scenes.push_back(load_scene(path));

  std::vector<SimbodyComparison> comparisons;
  for (const scenes::Scene& scene : scenes) {
    fmt::print(stderr, "{}\n", scene.name);
    for (SimbodyComparison& c : compare_with_simbody(scene, arguments.t)) comparisons.push_back(std::move(c));
  }
  fmt::print(stderr, "{}", failures(comparisons));
  fmt::print("{}",
             arguments.json ? json(arguments, comparisons) : table(comparisons) + refusals(comparisons));
  csv_file << csv(comparisons);

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
  app.add_option("scenes", arguments.scenes, "Scene files or names of the catalogue (default: all of it)");
  app.add_option("--time", arguments.t, "The time of the scenes' states [s]");
  app.add_flag("--json", arguments.json, "Print JSON");
  app.add_option("--csv", arguments.csv, "Also write the table to this file");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_done : exit_input_error;
  }
  return run_guarded([&] { return run(arguments); });
}
