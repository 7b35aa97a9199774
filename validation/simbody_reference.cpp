/// Question: are the accelerations, multipliers and reactions equal to those of Simbody? Every scene is
/// rebuilt in Simbody in three ways: as a tree of mobilizers, as free bodies with one custom constraint for
/// each row, and as free bodies with Simbody's own constraints. Each is compared with every formulation. The
/// program fails if a solver fails, or if a relative difference exceeds max(1e-10, 100 u kappa). The floor
/// 1e-10 is chosen by experiment.
///
/// The column `idle` counts closing rows that the tree of mobilizers satisfies identically; they are disabled
/// (simbody/way.hpp). A physical twin is the scene with larger inertias (simbody/physical_inertia.hpp).

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/json_writer.hpp"
#include "base/option_checks.hpp"
#include "base/progress.hpp"
#include "base/table.hpp"
#include "validation/harness/program.hpp"
#include "validation/simbody/comparison.hpp"

namespace trivium {

namespace {

std::string verdict_of(const SimbodyComparison& c) {
  if (!c.possible) return "none";
  if (!c.solved()) return "ERROR";
  return c.agrees() ? "agrees" : "DIFFERS";
}

std::string way_of(const SimbodyComparison& c) {
  return std::string(name_of(c.way)) + (c.twin ? ", twin" : "");
}

/// The fields of one comparison as text; an unknown value is "none".
struct Fields {
  Fields(const SimbodyComparison& c, std::string (*number)(double)) {
    const SimbodyDistance d = c.worst();
    const auto known = [&](bool is, const std::string& text) { return is ? text : std::string("none"); };
    nb = std::to_string(c.nb);
    nc = known(c.compared(), std::to_string(c.nc));
    rank = known(c.compared(), std::to_string(c.rank));
    mobilizers = known(c.compared(), std::to_string(c.mobilizers));
    constraint_rows = known(c.compared(), std::to_string(c.constraint_rows));
    idle_rows = known(c.compared(), std::to_string(c.idle_rows));
    kappa = known(c.compared(), number(c.kappa));
    pose_defect = known(c.compared(), number(c.pose_defect));
    acceleration = known(c.solved(), number(d.acceleration));
    lambda = known(c.solved() && c.any_unique, number(d.lambda));
    reaction = known(c.solved() && c.any_constraint, number(d.reaction));
    bound = known(c.compared(), number(c.bound()));
  }
  std::string nb, nc, rank, mobilizers, constraint_rows, idle_rows, kappa, pose_defect, acceleration, lambda,
      reaction, bound;
};

std::string short_number(double x) { return fmt::format("{:.1e}", x); }

std::string table(const std::vector<SimbodyComparison>& comparisons) {
  Table table({"scene", "way", "nb", "nc", "rank", "mobilizers", "rows", "idle", "kappa", "acceleration",
               "lambda", "reaction", "bound", "verdict"});
  for (const SimbodyComparison& c : comparisons) {
    const Fields f(c, short_number);
    table.add({c.scene, way_of(c), f.nb, f.nc, f.rank, f.mobilizers, f.constraint_rows, f.idle_rows, f.kappa,
               f.acceleration, f.lambda, f.reaction, f.bound, verdict_of(c)});
  }
  return table.text();
}

/// One line that names all scenes without a mobilizer.
std::string impossibilities(const std::vector<SimbodyComparison>& comparisons) {
  std::vector<std::string> scenes;
  for (const SimbodyComparison& c : comparisons)
    if (!c.possible) scenes.push_back(c.scene);
  if (scenes.empty()) return "";
  return fmt::format("\nmobilizers: none, because Simbody has no mobilizer for any joint of {}\n",
                     fmt::join(scenes, ", "));
}

/// One line for each scene and way that Simbody refused.
std::string refusals(const std::vector<SimbodyComparison>& comparisons) {
  std::string out;
  for (const SimbodyComparison& c : comparisons)
    if (c.twin)
      out += fmt::format(
          "{}, {}: Simbody cannot solve the scene, so a physical twin (the scene with larger inertias) is "
          "compared instead: {}\n",
          c.scene, name_of(c.way), c.refusal);
  return out.empty() ? out : "\n" + out;
}

/// The reason why a comparison is missing or incomplete.
std::string reason(const SimbodyComparison& c) {
  if (!c.error.empty()) return c.error;
  if (!c.failure.empty()) return "Simbody cannot solve the physical twin: " + c.failure;
  std::string out;
  for (const SimbodyDistance& d : c.formulations)
    if (!d.error.empty()) out += fmt::format("{}{}: {}", out.empty() ? "" : "; ", d.formulation, d.error);
  return out;
}

std::string failures(const std::vector<SimbodyComparison>& comparisons) {
  ErrorLines lines;
  for (const SimbodyComparison& c : comparisons)
    if (c.possible && !c.solved()) lines.add(c.error, way_of(c));
  return lines.text();
}

std::string json(double t, const std::vector<SimbodyComparison>& comparisons) {
  JsonWriter json;
  json.begin_object().number("t", t).begin_array("comparisons");
  for (const SimbodyComparison& c : comparisons) {
    json.begin_object()
        .text("scene", c.scene)
        .text("way", name_of(c.way))
        .flag("twin", c.twin)
        .number("nb", c.nb);
    if (c.compared())
      json.number("nc", c.nc)
          .number("rank", c.rank)
          .number("mobilizers", c.mobilizers)
          .number("constraint_rows", c.constraint_rows)
          .number("idle_rows", c.idle_rows)
          .number("kappa", c.kappa)
          .number("pose_defect", c.pose_defect)
          .number("bound", c.bound());
    json.text("verdict", verdict_of(c)).text("refusal", c.refusal).text("failure", c.failure);
    if (c.possible && !c.solved()) json.text("error", c.error);
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

/// The results file: one row for each scene and way.
ResultsFile results(const std::vector<SimbodyComparison>& comparisons) {
  ResultsFile file(
      "simbody_reference",
      {"scene", "way", "twin", "nb", "nc", "rank", "mobilizers", "constraint_rows", "idle_rows", "kappa",
       "pose_defect", "acceleration", "lambda", "reaction", "bound", "verdict", "refusal"});
  for (const SimbodyComparison& c : comparisons) {
    const Fields f(c, results_number);
    file.add({c.scene, std::string(name_of(c.way)), c.twin ? "yes" : "no", f.nb, f.nc, f.rank, f.mobilizers,
              f.constraint_rows, f.idle_rows, f.kappa, f.pose_defect, f.acceleration, f.lambda, f.reaction,
              f.bound, verdict_of(c), c.refusal});
  }
  return file;
}

int run(const Program& program, double t) {
  const std::vector<NamedScene> scenes = program.scenes(t);
  std::vector<SimbodyComparison> comparisons;
  {
    Progress progress("simbody_reference", scenes.size());
    for (const NamedScene& named : scenes) {
      for (SimbodyComparison& c : compare_with_simbody(named)) {
        if (c.possible && !c.solved()) c.error = name_source(named.source, reason(c));
        comparisons.push_back(std::move(c));
      }
      progress.step();
    }
  }
  program.write(results(comparisons));
  fmt::print("{}", program.json() ? json(t, comparisons)
                                  : table(comparisons) + impossibilities(comparisons) +
                                        refusals(comparisons) + failures(comparisons));

  const auto all = [&](auto is) { return std::all_of(comparisons.begin(), comparisons.end(), is); };
  return batch_exit(all([](const SimbodyComparison& c) { return !c.possible || c.solved(); }),
                    all([](const SimbodyComparison& c) { return !c.possible || c.agrees(); }));
}

}  // namespace

}  // namespace trivium

int main(int argc, char** argv) {
  using namespace trivium;
  Program program("Accelerations, multipliers and reactions of scenes against Simbody", "simbody_reference");
  double t = 0;
  program.options().add_option("--t,--time", &t, "Time of the states of the scenes [s]").check(finite_time());
  return program.run(argc, argv, [&] { return run(program, t); });
}
