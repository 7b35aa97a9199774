/// Question: does the difference between the formulations decrease with the unit roundoff u? The same states
/// are solved in float, double, long double, quad and 50 digits. The table shows the largest difference of
/// lambda between any two formulations and its ratio to u kappa. The program fails if a solver fails, or if a
/// difference exceeds 100 u kappa (in 50 digits max(100 u kappa, 1e-45)).

#include <fmt/format.h>

#include <optional>
#include <type_traits>
#include <utility>

#include "base/error.hpp"
#include "base/json_writer.hpp"
#include "base/progress.hpp"
#include "base/table.hpp"
#include "bodies/numbers/quad.hpp"
#include "bodies/numbers/real50.hpp"
#include "bodies/numbers/scalar.hpp"
#include "formulations/side_by_side.hpp"
#include "scenes/make_mechanism.hpp"
#include "validation/harness/program.hpp"

namespace trivium {

namespace {

/// Larger scenes of the catalogue are only solved with --large, since a dense matrix in 50 digits takes
/// minutes. Scenes that the command line names are solved at any size.
constexpr std::size_t quick_bodies = 30;

struct PrecisionResult {
  std::string scene, scalar, error;
  int nb = 0, nc = 0, rank = 0;
  double u = 0, kappa = 0, cancellation = 1, difference = 0;
  bool analysed = false;  ///< nc, rank, kappa and any_unique are known
  bool any_unique = true;

  bool solved() const { return error.empty(); }
  bool comparable() const { return solved() && any_unique; }
  double ratio() const { return difference / (u * kappa); }
  /// 100 u kappa, but at least 1e-45 for 50 digits, the only scalar with u < 1e-45. The limit 1e-45 is chosen
  /// by experiment.
  double bound() const { return std::max(lambda_bound(u, kappa), u < 1e-45 ? 1e-45 : 0.0); }
  bool passed() const { return solved() && (!any_unique || difference <= bound()); }
  /// Whether the difference exceeds the bound by at most the factor by which the terms that determine lambda
  /// cancel.
  bool cancels() const { return difference <= bound() * cancellation; }
  std::string verdict() const {
    return !solved()               ? "ERROR"
           : !any_unique           ? "none"
           : difference <= bound() ? "ok"
           : cancels()             ? "cancels"
                                   : "EXCEEDS";
  }
};

/// The analysis of the rows is made once, in double, and is used in all precisions.
struct RowsOrError {
  std::optional<RowAnalysis> analysis;
  std::string error;
};

template <class Scalar>
Model<Scalar> model_in(const NamedScene& named) {
  if constexpr (std::is_same_v<Scalar, double>)
    return named.model();
  else
    return make_model<Scalar>(named.scene);
}

template <class Scalar>
void compare(const NamedScene& named, const RowAnalysis& rows, PrecisionResult& rung) {
  const SideBySide<Scalar> result = side_by_side(model_in<Scalar>(named), rows);
  rung.analysed = true;
  rung.nc = static_cast<int>(result.rows.unique.size());
  rung.rank = result.rows.rank;
  rung.kappa = result.rows.kappa;
  rung.cancellation = result.cancellation();
  rung.any_unique = result.any_unique();
  result.require_solved();
  rung.difference = result.discrepancy().lambda;
}

template <class Scalar>
PrecisionResult solve_in(const NamedScene& named, const RowsOrError& rows, const char* scalar) {
  PrecisionResult rung{named.scene.name, scalar, ""};
  rung.nb = static_cast<int>(named.scene.bodies.size());
  rung.u = static_cast<double>(unit_roundoff<Scalar>());
  try {
    if (!rows.analysis) throw ModelError(rows.error);
    compare<Scalar>(named, *rows.analysis, rung);
  } catch (const ModelError& error) {
    rung.error = name_source(named.source, error.what());
  }
  return rung;
}

std::vector<PrecisionResult> solve_in_all(const NamedScene& scene) {
  RowsOrError rows;
  try {
    rows.analysis = analyse_rows(scene.model());
  } catch (const ModelError& error) {
    rows.error = error.what();
  }
  return {solve_in<float>(scene, rows, "float"), solve_in<double>(scene, rows, "double"),
          solve_in<long double>(scene, rows, "long double"), solve_in<Quad>(scene, rows, "quad"),
          solve_in<Real50>(scene, rows, "50 digits")};
}

std::vector<std::string> columns() {
  return {"scene", "nb", "nc", "rank", "kappa", "scalar", "u", "difference", "bound", "verdict"};
}

std::vector<std::string> fields(const PrecisionResult& r) {
  const auto known = [&](const std::string& text) { return r.analysed ? text : std::string("none"); };
  return {r.scene,
          std::to_string(r.nb),
          known(std::to_string(r.nc)),
          known(std::to_string(r.rank)),
          known(results_number(r.kappa)),
          r.scalar,
          results_number(r.u),
          r.comparable() ? results_number(r.difference) : "none",
          known(results_number(r.bound())),
          r.verdict()};
}

/// One line for each scene: the difference in each precision, and in brackets its ratio to u kappa.
std::string text(const std::vector<PrecisionResult>& rungs, std::size_t rungs_per_scene) {
  std::vector<std::string> header{"scene", "nb", "kappa"};
  for (std::size_t k = 0; k < rungs_per_scene && k < rungs.size(); ++k)
    header.push_back(rungs[k].scalar + " (/u kappa)");
  header.push_back("verdict");
  Table table(header);
  ErrorLines errors;
  for (std::size_t first = 0; first < rungs.size(); first += rungs_per_scene) {
    std::vector<std::string> row{rungs[first].scene, std::to_string(rungs[first].nb),
                                 rungs[first].analysed ? fmt::format("{:.1e}", rungs[first].kappa) : "none"};
    // The worst verdict of all precisions: ERROR is worse than EXCEEDS, and EXCEEDS is worse than cancels.
    std::string verdict = rungs[first].any_unique ? "ok" : "none";
    for (std::size_t k = first; k < first + rungs_per_scene; ++k) {
      const PrecisionResult& r = rungs[k];
      row.push_back(r.comparable() ? fmt::format("{:.0e} ({:.1g})", r.difference, r.ratio()) : "none");
      if (!r.solved()) errors.add(r.error, r.scalar);
      const bool is_worse = !r.solved() || (verdict != "ERROR" && verdict != "EXCEEDS");
      if (!r.passed() && is_worse) verdict = r.verdict();
    }
    row.push_back(verdict);
    table.add(row);
  }
  return table.text() + errors.text();
}

std::string json(const std::vector<PrecisionResult>& rungs, bool passed) {
  JsonWriter out;
  out.begin_object().flag("passed", passed).begin_array("rungs");
  for (const PrecisionResult& r : rungs) {
    out.begin_object().text("scene", r.scene).number("nb", r.nb);
    if (r.analysed) out.number("kappa", r.kappa);
    out.text("scalar", r.scalar).number("u", r.u);
    if (r.comparable()) out.number("difference", r.difference).number("ratio", r.ratio());
    if (r.analysed) out.number("bound", r.bound());
    out.text("verdict", r.verdict());
    if (!r.solved()) out.text("error", r.error);
    out.end_object();
  }
  return out.end_array().end_object().str();
}

int run(const Program& program, bool large) {
  std::vector<NamedScene> scenes = program.scenes(0);
  if (!program.names_scenes() && !large)
    std::erase_if(scenes, [](const NamedScene& s) { return s.scene.bodies.size() > quick_bodies; });
  std::vector<PrecisionResult> rungs;
  std::size_t per_scene = 1;
  Progress progress("precision_ladder", scenes.size());
  for (const NamedScene& scene : scenes) {
    const std::vector<PrecisionResult> ladder = solve_in_all(scene);
    per_scene = ladder.size();
    rungs.insert(rungs.end(), ladder.begin(), ladder.end());
    progress.step();
  }
  const auto all = [&](auto is) { return std::all_of(rungs.begin(), rungs.end(), is); };
  const bool solved = all([](const PrecisionResult& r) { return r.solved(); });
  const bool passed = all([](const PrecisionResult& r) { return r.passed(); });
  ResultsFile file("precision_ladder", columns());
  for (const PrecisionResult& rung : rungs) file.add(fields(rung));
  program.write(file);
  fmt::print("{}", program.json() ? json(rungs, passed) : text(rungs, per_scene));
  return batch_exit(solved, passed);
}

}  // namespace

}  // namespace trivium

int main(int argc, char** argv) {
  using namespace trivium;
  Program program("Does the difference between the formulations decrease with the unit roundoff?",
                  "precision_ladder", "the catalogue up to 30 bodies");
  bool large = false;
  program.options().add_flag("--large", &large,
                             "Include the scenes of the catalogue beyond 30 bodies (minutes)");
  return program.run(argc, argv, [&] { return run(program, large); });
}
