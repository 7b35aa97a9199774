/// Question: what does accuracy cost in time? The same motions are computed by every method in the
/// timed formulations and by Simbody's own integrators, at tolerances from loose to tight. Errors refer to
/// one reference solution. CPU times are measured in separate runs, in random order; only their ratios are
/// meaningful. The program fails only if a scene has no reference.

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "base/json_writer.hpp"
#include "base/progress.hpp"
#include "scenes/generators.hpp"
#include "validation/harness/program.hpp"
#include "validation/precision/plot.hpp"

namespace trivium::precision {

namespace {

/// Lengths of the runs [s]; 1 s for other scenes. Some periods of each motion, so that errors grow visibly;
/// the run of the four-bars ends before they lie flat.
const std::map<std::string, double> lengths{
    {"two_bars", 10}, {"a01_pendulum", 10},    {"n_four_bar_2", 0.6},  {"andrews_squeezer", 0.05},
    {"bricard", 5},   {"flyball_governor", 1}, {"stewart_platform", 2}};

struct Options {
  bool quick = false;
  int repetitions = 5;
  std::string plots;
};

std::vector<TimedMotion> motions(const Program& program) {
  std::vector<std::string> names = program.names();
  if (names.empty())
    names = {"two_bars", "a01_pendulum",     "n_four_bar_2",    "andrews_squeezer",
             "bricard",  "flyball_governor", "stewart_platform"};
  std::vector<TimedMotion> all;
  for (const std::string& name : names) {
    NamedScene named = name == "two_bars" ? NamedScene(name, scenes::two_bars(), 0.0)
                                          : load_consistent_scenes({name}, 0).front();
    const auto known = lengths.find(named.scene.name);
    all.emplace_back(std::move(named), known == lengths.end() ? 1 : known->second);
  }
  return all;
}

std::vector<std::string> columns() {
  return {"scene",       "t_end",          "reference_error", "engine",   "formulation", "method",
          "setting",     "position",       "orientation",     "velocity", "reaction",    "drift",
          "energy",      "least_ms",       "median_ms",       "low_ms",   "high_ms",     "steps",
          "evaluations", "factorisations", "failure"};
}

std::vector<std::string> fields(const SceneResult& result, const RunResult& o) {
  const auto number = [&](double x) { return o.solved() ? results_number(x) : "none"; };
  const auto optional = [](const std::optional<double>& x) { return x ? results_number(*x) : "none"; };
  const auto word = [](const std::string& s) { return s.empty() ? std::string("none") : s; };
  return {result.scene,
          results_number(result.t_end),
          results_number(result.reference_error),
          o.settings.engine,
          word(o.settings.formulation),
          o.settings.method,
          o.settings.setting(),
          number(o.errors.position),
          number(o.errors.orientation),
          number(o.errors.velocity),
          optional(o.errors.reaction),
          optional(o.errors.drift),
          optional(o.errors.energy),
          number(1e3 * o.seconds.least),
          number(1e3 * o.seconds.median),
          number(1e3 * o.seconds.low),
          number(1e3 * o.seconds.high),
          std::to_string(o.steps),
          std::to_string(o.evaluations),
          std::to_string(o.factorisations),
          word(o.failure)};
}

std::string json(const std::vector<SceneResult>& results, const std::string& errors) {
  JsonWriter out;
  out.begin_object().begin_array("contests");
  for (const SceneResult& c : results) {
    out.begin_object()
        .text("scene", c.scene)
        .number("t_end", c.t_end)
        .number("reference_error", c.reference_error)
        .flag("trusted_numbers", c.is_trusted);
    out.begin_array("runs");
    for (const RunResult& o : c.runs) {
      out.begin_object()
          .text("engine", o.settings.engine)
          .text("method", o.settings.method)
          .text("setting", o.settings.setting());
      if (!is_peer(o.settings)) out.text("formulation", o.settings.formulation);
      if (o.solved()) {
        out.number("position", o.errors.position)
            .number("orientation", o.errors.orientation)
            .number("velocity", o.errors.velocity);
        if (o.errors.reaction) out.number("reaction", *o.errors.reaction);
        if (o.errors.drift) out.number("drift", *o.errors.drift);
        if (o.errors.energy) out.number("energy", *o.errors.energy);
        out.number("steps", o.steps)
            .number("evaluations", o.evaluations)
            .number("factorisations", o.factorisations)
            .number("least_ms", 1e3 * o.seconds.least)
            .number("median_ms", 1e3 * o.seconds.median)
            .number("low_ms", 1e3 * o.seconds.low)
            .number("high_ms", 1e3 * o.seconds.high);
      } else {
        out.text("failure", o.failure);
      }
      out.end_object();
    }
    out.end_array().end_object();
  }
  out.end_array();
  if (!errors.empty()) out.text("error", errors);
  return out.end_object().str();
}

int run(const Program& program, const Options& options) {
  const std::vector<TimedMotion> all = motions(program);
  const std::vector<RunSettings> entered = all_settings(options.quick);
  Progress progress("work_precision",
                    all.size() * (entered.size() + static_cast<std::size_t>(options.repetitions)));
  if (!options.plots.empty()) std::filesystem::create_directories(options.plots);
  std::vector<SceneResult> results;
  ErrorLines errors;
  for (const TimedMotion& motion : all) {
    std::optional<ReferenceMotion> reference;
    try {
      reference = reference_of(motion);
    } catch (const std::runtime_error& error) {
      errors.add(name_source(motion.scene.name, error.what()), "the reference");
      continue;
    }
    results.push_back(
        {motion.scene.name, motion.t_end, reference->own_error, reference->is_trusted,
         measure_runs(motion, *reference, entered, options.repetitions, [&] { progress.step(); })});
    if (!program.json()) fmt::print("{}", cost_table(results.back()));
    std::fflush(stdout);
    if (!options.plots.empty()) plot(results.back(), options.plots);
  }
  if (!program.json())
    fmt::print(
        "{}Times are medians of {} repetitions; the CSV file has their confidence intervals, of level "
        "{:.2f}.\nA run of one second or more is timed once, so its interval has zero width.\n",
        errors.text(), options.repetitions, confidence(options.repetitions));
  ResultsFile file("work_precision", columns());
  for (const SceneResult& c : results)
    for (const RunResult& o : c.runs) file.add(fields(c, o));
  program.write(file);
  if (program.json()) fmt::print("{}", json(results, errors.text()));
  return batch_exit(results.size() == all.size(), true);
}

}  // namespace

}  // namespace trivium::precision

int main(int argc, char** argv) {
  using namespace trivium;
  Program program("What does accuracy cost in time? SCENE may also be two_bars, a double pendulum in space.",
                  "work_precision", "two_bars, IFToMM A01 to A05 and the Stewart platform");
  precision::Options options;
  program.options().add_flag("--quick", &options.quick,
                             "At most two tolerances, or one step size, for each method; Simbody's methods "
                             "of order 1 and 2 are left out");
  program.options()
      .add_option("--repetitions", &options.repetitions, "Number of repetitions of every timed run")
      .between(1, 1000)
      .show_default();
  program.options().add_option("--plot", &options.plots, "Write SCENE.svg and SCENE.pdf to this folder");
  return program.run(argc, argv, [&] { return precision::run(program, options); });
}
