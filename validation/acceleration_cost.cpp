/// Question: what does one evaluation of the accelerations with all constraint forces cost, and how accurate
/// is it? The structured solver in the timed formulations, other engines and general sparse solvers are timed
/// in one run, in random order. The ratios of the times are meaningful; the microseconds depend on the
/// machine. The program fails if a Trivium solver fails on a scene, or if a refined solution differs by more
/// than 1e-9 from the solution in quad.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <functional>

#include "base/error.hpp"
#include "base/json_writer.hpp"
#include "base/number_text.hpp"
#include "base/progress.hpp"
#include "base/table.hpp"
#include "validation/cost/ensemble.hpp"
#include "validation/cost/measurement.hpp"
#include "validation/cost/peers.hpp"
#include "validation/cost/plots.hpp"
#include "validation/harness/program.hpp"

namespace trivium::cost {

namespace {

/// Largest accepted relative error of Trivium's refined accelerations [-], chosen by experiment: the errors
/// of all measured scenes are smaller.
constexpr double bound = 1e-9;

struct Options {
  bool quick = false;
  std::string plots;
};

std::string shown(const std::optional<double>& x, const char* format) {
  return x ? fmt::format(fmt::runtime(format), *x) : "-";
}

std::string refined_formulation(const Measurement& row) {
  if (row.refinement.empty()) return row.formulation.empty() ? "-" : row.formulation;
  return row.formulation + (row.refinement == "refined" ? ", refined" : "");
}

std::string notes(const std::vector<Measurement>& rows) {
  std::string out;
  for (const Measurement& row : rows)
    if (!row.note.empty())
      out += fmt::format("{}{}: {}\n", row.engine, row.ours ? " " + refined_formulation(row) : "", row.note);
  return out;
}

std::string table(const std::vector<Measurement>& rows) {
  Table table({"engine", "formulation", "us", "us/body", "ratio", "error", "lambda error", "KiB"});
  for (const Measurement& row : rows)
    table.add({row.engine, refined_formulation(row), row.failed ? "fails" : shown(row.microseconds, "{:.3g}"),
               row.microseconds ? fmt::format("{:.3g}", row.microseconds_per_body()) : "-",
               shown(row.ratio, "{:.2f}"), shown(row.error, "{:.1e}"), shown(row.lambda_error, "{:.1e}"),
               shown(row.kilobytes, "{:.0f}")});
  return fmt::format("{}: {}\n{}{}\n", rows.front().scene,
                     counted(static_cast<std::size_t>(rows.front().bodies), "body", "bodies"), table.text(),
                     notes(rows));
}

std::string ensemble_table(const std::vector<Measurement>& rows) {
  Table table({"engine", "formulation", "states/s", "us/state", "ratio", "error"});
  for (const Measurement& row : rows)
    table.add({row.engine, refined_formulation(row), fmt::format("{:.0f}", 1e6 / *row.microseconds),
               shown(row.microseconds, "{:.3g}"), shown(row.ratio, "{:.2f}"), shown(row.error, "{:.1e}")});
  return fmt::format("ensemble: {} states of an arm of {} joints, one core\n{}\n", rows.front().n,
                     rows.front().bodies, table.text());
}

std::vector<std::string> columns() {
  return {"scene",       "n",          "bodies",       "engine",
          "formulation", "refinement", "microseconds", "microseconds_per_body",
          "ratio",       "error",      "lambda_error", "kilobytes",
          "note"};
}

std::vector<std::string> fields(const Measurement& row) {
  const auto number = [](const std::optional<double>& x) { return x ? results_number(*x) : "none"; };
  const auto word = [](const std::string& s) { return s.empty() ? std::string("none") : s; };
  return {row.scene,
          row.n > 0 ? std::to_string(row.n) : "none",
          std::to_string(row.bodies),
          row.engine,
          word(row.formulation),
          word(row.refinement),
          number(row.microseconds),
          row.microseconds ? results_number(row.microseconds_per_body()) : "none",
          number(row.ratio),
          number(row.error),
          number(row.lambda_error),
          number(row.kilobytes),
          word(row.note)};
}

std::string json(const std::vector<Measurement>& rows, bool passed) {
  JsonWriter out;
  out.begin_object().flag("passed", passed).begin_array("measurements");
  for (const Measurement& row : rows) {
    const auto number = [&](const char* key, const std::optional<double>& x) {
      if (x) out.number(key, *x);
    };
    out.begin_object().text("scene", row.scene);
    if (row.n > 0) out.number("n", row.n);
    out.number("bodies", row.bodies).text("engine", row.engine);
    if (!row.formulation.empty()) out.text("formulation", row.formulation);
    if (!row.refinement.empty()) out.text("refinement", row.refinement);
    number("microseconds", row.microseconds);
    if (row.microseconds) out.number("microseconds_per_body", row.microseconds_per_body());
    number("ratio", row.ratio);
    number("error", row.error);
    number("lambda_error", row.lambda_error);
    number("kilobytes", row.kilobytes);
    if (!row.note.empty()) out.text("note", row.note);
    out.end_object();
  }
  return out.end_array().end_object().str();
}

/// Measures all chosen scenes. Tables are printed as soon as they are complete.
class Run {
 public:
  Run(const Program& program, const Options& options) : program_(program), options_(options) {
    if (options.quick) timing_ = {0.01, 5};  // too short for figures, long enough to run every path
  }

  int operator()() {
    std::vector<std::string> names = program_.names();
    const bool with_ensemble = names.empty() || std::erase(names, "ensemble") > 0;
    if (program_.names().empty()) names = default_scene_names(options_.quick);
    const std::vector<TimedScene> scenes = timed_scenes(names);
    for (const std::string& peer : missing_peers())
      fmt::print(stderr, "acceleration_cost: {} was not installed at build time and is left out\n", peer);
    Progress progress("acceleration_cost", scenes.size() + (with_ensemble ? 1 : 0));
    for (const TimedScene& scene : scenes) {
      take(
          scene.name, [&] { return measure(scene, timing_); }, table);
      progress.step();
    }
    if (with_ensemble) {
      // many portions (ensemble.hpp) for the median of their times
      take(
          "ensemble", [&] { return measure_ensemble(options_.quick ? 40000 : 1000000); }, ensemble_table);
      progress.step();
    }
    return finish();
  }

 private:
  void take(const std::string& scene, const std::function<std::vector<Measurement>()>& measured,
            const std::function<std::string(const std::vector<Measurement>&)>& text) {
    try {
      const std::vector<Measurement> rows = measured();
      if (!program_.json()) {
        fmt::print("{}", text(rows));
        std::fflush(stdout);
      }
      rows_.insert(rows_.end(), rows.begin(), rows.end());
    } catch (const ModelError& error) {
      fmt::print(stderr, "error: {}\n", name_source(scene, error.what()));
      solved_ = false;
    }
  }

  int finish() {
    const auto all_of_ours = [&](auto is) {
      return std::all_of(rows_.begin(), rows_.end(),
                         [&](const Measurement& row) { return !row.ours || is(row); });
    };
    const bool solved = solved_ && all_of_ours([](const Measurement& row) { return !row.failed; });
    const bool passed = all_of_ours([](const Measurement& row) {
      return row.refinement != "refined" || row.failed || (row.error && *row.error <= bound);
    });
    ResultsFile file("acceleration_cost", columns());
    for (const Measurement& row : rows_) file.add(fields(row));
    program_.write(file);
    if (program_.json()) fmt::print("{}", json(rows_, passed));
    if (!options_.plots.empty()) write_plots(rows_, options_.plots);
    return batch_exit(solved, passed);
  }

  const Program& program_;
  Options options_;
  Timing timing_;
  std::vector<Measurement> rows_;
  bool solved_ = true;
};

}  // namespace

}  // namespace trivium::cost

int main(int argc, char** argv) {
  using namespace trivium;
  Program program(
      "What does one evaluation of the accelerations with all constraint forces cost, and how exact is it?\n"
      "SCENE may also be chain_N, ladder_N, tree_N, ring_N, hub_N and ensemble. docs/cost.md explains the "
      "timing.",
      "acceleration_cost", "chains, ladders, a tree, the Stewart platform, a ring, a hub and the ensemble");
  cost::Options options;
  program.options().add_flag("--quick", &options.quick, "Fewer sizes and shorter repetitions");
  program.options().add_option("--plot", &options.plots, "Write chain.svg and ladder.svg to this folder");
  return program.run(argc, argv, [&] { return cost::Run(program, options)(); });
}
