/// Does the difference between the formulations fall with the precision? The same states in float, double,
/// long double, quad and 50 digits: the largest difference of lambda between any two formulations, and its
/// ratio to u kappa.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <utility>

#include "formulations/side_by_side.hpp"
#include "validation/catalogue.hpp"
#include "validation/progress.hpp"
#include "validation/results_file.hpp"
#include "validation/text_output.hpp"

namespace trivium {

namespace {

struct Arguments {
  std::vector<std::string> scenes;
  bool json = false, large = false;
  std::string csv;
};

/// Scenes beyond this many bodies are left to the long run: 50 digits on a dense matrix take minutes there.
constexpr std::size_t quick_bodies = 30;

struct Rung {
  std::string scene, scalar, error;
  int nb = 0, nc = 0, rank = 0;
  double u = 0, kappa = 0, difference = 0;
  bool any_unique = true;

  double ratio() const { return difference / (u * kappa); }
  /// 100 u kappa; beyond 45 digits the data, which are doubles, leave 1e-45.
  double bound() const { return std::max(100 * u * kappa, u < 1e-45 ? 1e-45 : 0.0); }
  bool passed() const { return error.empty() && (!any_unique || difference <= bound()); }
  std::string verdict() const {
    return !error.empty() ? "ERROR" : !any_unique ? "none" : passed() ? "ok" : "EXCEEDS";
  }
};

template <class Scalar>
Rung climb(const scenes::Scene& scene, const char* scalar) {
  SolveOptions options;
  options.estimate_errors = false;
  const SideBySide<Scalar> result = solve_side_by_side<Scalar>(scene, 0, options);
  Rung rung{scene.name, scalar, ""};
  rung.nb = static_cast<int>(scene.bodies.size());
  rung.nc = static_cast<int>(result.rows.unique.size());
  rung.rank = result.rows.rank;
  rung.u = static_cast<double>(unit_roundoff<Scalar>());
  rung.kappa = result.rows.kappa;
  rung.any_unique = result.any_unique();
  rung.difference = result.discrepancy().lambda;
  for (const auto& f : result.formulations)
    if (!f.error.empty()) rung.error = fmt::format("{}: {}", f.name, f.error);
  return rung;
}

std::vector<Rung> climb_all(const scenes::Scene& scene) {
  return {climb<float>(scene, "float"), climb<double>(scene, "double"),
          climb<long double>(scene, "long double"), climb<Quad>(scene, "quad"),
          climb<Real50>(scene, "50 digits")};
}

std::vector<std::string> columns() {
  return {"scene", "nb", "nc", "rank", "kappa", "scalar", "u", "difference", "bound", "verdict"};
}

std::vector<std::string> fields(const Rung& r) {
  return {r.scene,
          std::to_string(r.nb),
          std::to_string(r.nc),
          std::to_string(r.rank),
          results_number(r.kappa),
          r.scalar,
          results_number(r.u),
          r.any_unique ? results_number(r.difference) : "none",
          results_number(r.bound()),
          r.verdict()};
}

/// One line a scene: the difference in each precision, and in brackets its ratio to u kappa.
std::string text(const std::vector<Rung>& rungs, std::size_t rungs_per_scene) {
  std::vector<std::string> header{"scene", "nb", "kappa"};
  for (std::size_t k = 0; k < rungs_per_scene && k < rungs.size(); ++k)
    header.push_back(rungs[k].scalar + " (/u kappa)");
  header.push_back("verdict");
  Table table(header);
  std::string errors;
  for (std::size_t first = 0; first < rungs.size(); first += rungs_per_scene) {
    std::vector<std::string> row{rungs[first].scene, std::to_string(rungs[first].nb),
                                 fmt::format("{:.1e}", rungs[first].kappa)};
    std::string verdict = rungs[first].any_unique ? "ok" : "none";
    for (std::size_t k = first; k < first + rungs_per_scene; ++k) {
      const Rung& r = rungs[k];
      row.push_back(r.any_unique ? fmt::format("{:.0e} ({:.1g})", r.difference, r.ratio()) : "none");
      if (!r.passed()) verdict = r.verdict();
      if (!r.error.empty()) errors += fmt::format("{} in {}: {}\n", r.scene, r.scalar, r.error);
    }
    row.push_back(verdict);
    table.add(row);
  }
  return table.text() + errors;
}

std::string json(const std::vector<Rung>& rungs, bool passed) {
  JsonWriter out;
  out.begin_object().flag("passed", passed).begin_array("rungs");
  for (const Rung& r : rungs) {
    out.begin_object()
        .text("scene", r.scene)
        .number("nb", r.nb)
        .number("kappa", r.kappa)
        .text("scalar", r.scalar)
        .number("u", r.u);
    if (r.any_unique) out.number("difference", r.difference).number("ratio", r.ratio());
    out.number("bound", r.bound()).text("verdict", r.verdict());
    if (!r.error.empty()) out.text("error", r.error);
    out.end_object();
  }
  return out.end_array().end_object().str();
}

int run(const Arguments& arguments, int argc, char** argv) {
  std::vector<scenes::Scene> scenes;
  for (const std::string& name : arguments.scenes) scenes.push_back(load_consistent_scene(name, 0));
  if (scenes.empty())
    for (const auto& file : catalogue())
      if (scenes::Scene scene = load_scene(file.string());
          arguments.large || scene.bodies.size() <= quick_bodies)
        scenes.push_back(std::move(scene));
  std::vector<Rung> rungs;
  std::size_t per_scene = 1;
  Progress progress("precision_ladder", scenes.size());
  for (const scenes::Scene& scene : scenes) {
    const std::vector<Rung> ladder = climb_all(scene);
    per_scene = ladder.size();
    rungs.insert(rungs.end(), ladder.begin(), ladder.end());
    progress.step();
  }
  const bool passed = std::all_of(rungs.begin(), rungs.end(), [](const Rung& r) { return r.passed(); });
  if (!arguments.csv.empty()) {
    ResultsFile file("precision_ladder", columns());
    for (const Rung& rung : rungs) file.add(fields(rung));
    file.write(arguments.csv, argc, argv);
  }
  fmt::print("{}", arguments.json ? json(rungs, passed) : text(rungs, per_scene));
  return passed ? exit_done : exit_criterion_failed;
}

}  // namespace

}  // namespace trivium

int main(int argc, char** argv) {
  using namespace trivium;
  CLI::App app{"Does the difference between the formulations fall with the precision?", "precision_ladder"};
  Arguments arguments;
  app.set_version_flag("--version", "trivium " TRIVIUM_VERSION);
  app.add_option("SCENE", arguments.scenes,
                 "Scene files or catalogue names (default: the catalogue up to 30 bodies)");
  app.add_flag("--large", arguments.large, "The catalogue's scenes beyond 30 bodies too (minutes)");
  app.add_flag("--json", arguments.json, "JSON on stdout");
  app.add_option("--csv", arguments.csv, "Write the table to this CSV file, and a manifest beside it");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_done : exit_input_error;
  }
  return run_guarded([&] { return run(arguments, argc, argv); });
}
