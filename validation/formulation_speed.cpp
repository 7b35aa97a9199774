/// Question: which set of coordinates is fastest, and does the order of the method change the answer? Kissel,
/// Taves and Negrut (2021, 2022) found r-omega on SO(3) (their rA) about twice as fast as r-p and r-epsilon
/// with backward Euler, and left higher orders open. Here their four models and spatial models with free
/// degrees of freedom are run by methods of orders 1 to 5, with the same solver, step size and Newton
/// criterion. CPU times are taken in random order; only ratios are meaningful. The program fails only if a
/// run fails.

#include <fmt/format.h>

#include <algorithm>

#include "base/json_writer.hpp"
#include "base/progress.hpp"
#include "base/table.hpp"
#include "simulation/simulate.hpp"
#include "validation/harness/interleaved_timing.hpp"
#include "validation/harness/program.hpp"
#include "validation/harness/timed_formulations.hpp"

namespace trivium {

namespace {

struct Method {
  std::string label, name;
  integrators::MethodParameters parameters;
};

const std::vector<Method>& methods() {
  static const std::vector<Method> all{{"bdf1 (backward Euler)", "bdf", {.order = 1}},
                                       {"bdf2", "bdf", {.order = 2}},
                                       {"bdf4", "bdf", {.order = 4}},
                                       {"generalized-alpha", "generalized-alpha", {}},
                                       {"dopri5", "dopri5", {}}};
  return all;
}

const std::vector<std::string>& formulations() {
  static const std::vector<std::string> all = TimedFormulations::names();
  return all;
}

struct Run {
  std::string scene, formulation, failure;
  const Method* method = nullptr;
  std::vector<double> seconds = {};
  long steps = 0, iterations = 0, evaluations = 0;
  double ratio = 0;  ///< ratio of the median time to that of r-omega [-]

  bool solved() const { return failure.empty(); }
  double median() const { return median_of(seconds); }
  double microseconds_per_step() const { return 1e6 * median() / static_cast<double>(steps); }
  double per_step(long count) const { return static_cast<double>(count) / static_cast<double>(steps); }
};

struct Options {
  double step = 1e-3, t_end = 0.2;
  int repetitions = 9;
};

SimulationReport simulate_once(const Model<double>& model, const Run& run, const Options& options) {
  SimulationOptions o;
  o.formulation = run.formulation;
  o.integrator = run.method->name;
  o.parameters = run.method->parameters;
  o.step = options.step;
  o.end = options.t_end;
  o.watches = false;
  SimulationObserver nobody;
  return simulate(model, o, nobody);
}

std::vector<Run> measure(const NamedScene& named, const Options& options, Progress& progress) {
  std::vector<Run> runs;
  for (const Method& method : methods())
    for (const std::string& formulation : formulations())
      runs.push_back({named.scene.name, formulation, "", &method});
  interleave(
      runs.size(), options.repetitions,
      [&](std::size_t n) {
        Run& run = runs[n];
        if (!run.solved()) return;
        try {
          const SimulationReport report = simulate_once(named.model(), run, options);
          run.seconds.push_back(report.seconds);
          run.steps = report.counters.steps;
          run.iterations = report.counters.iterations;
          run.evaluations = report.counters.right_sides;
        } catch (const std::runtime_error& error) {
          run.failure = name_source(named.source, error.what());
        }
      },
      [&] { progress.step(); });
  for (std::size_t n = 0; n < runs.size(); ++n) {
    const Run& by_omega = runs[n - n % formulations().size()];
    if (runs[n].solved() && by_omega.solved()) runs[n].ratio = runs[n].median() / by_omega.median();
  }
  return runs;
}

std::string text(const std::vector<Run>& runs) {
  std::vector<std::string> header{"scene", "method", formulations().front() + " us/step"};
  header.insert(header.end(), formulations().begin() + 1, formulations().end());
  header.emplace_back("iterations/step");
  Table table(header);
  ErrorLines errors;
  for (std::size_t n = 0; n < runs.size(); n += formulations().size()) {
    const Run* r = &runs[n];
    const auto ratio = [&](const Run& run) {
      return run.ratio > 0 ? fmt::format("{:.2f} x", run.ratio) : "-";
    };
    const auto iterations = [&](const Run& run) {
      return run.solved() ? fmt::format("{:.2f}", run.per_step(run.iterations)) : "-";
    };
    std::vector<std::string> row{r->scene, r->method->label,
                                 r->solved() ? fmt::format("{:.2f}", r->microseconds_per_step()) : "-"};
    std::string all_iterations = iterations(r[0]);
    for (std::size_t k = 1; k < formulations().size(); ++k) {
      row.push_back(ratio(r[k]));
      all_iterations += " / " + iterations(r[k]);
    }
    row.push_back(all_iterations);
    table.add(row);
    for (std::size_t k = 0; k < formulations().size(); ++k)
      if (!r[k].solved()) errors.add(r[k].failure, r[k].formulation + ", " + r[k].method->label);
  }
  return table.text() + errors.text();
}

std::vector<std::string> columns() {
  return {"scene",
          "method",
          "formulation",
          "us_per_step",
          "ratio",
          "iterations_per_step",
          "evaluations_per_step"};
}

std::vector<std::string> fields(const Run& run) {
  const auto number = [&](double x) { return run.solved() ? results_number(x) : "none"; };
  return {run.scene,
          run.method->label,
          run.formulation,
          run.solved() ? number(run.microseconds_per_step()) : "none",
          run.ratio > 0 ? number(run.ratio) : "none",
          run.solved() ? number(run.per_step(run.iterations)) : "none",
          run.solved() ? number(run.per_step(run.evaluations)) : "none"};
}

std::string json(const std::vector<Run>& runs) {
  JsonWriter out;
  out.begin_object().begin_array("runs");
  for (const Run& run : runs) {
    out.begin_object()
        .text("scene", run.scene)
        .text("method", run.method->label)
        .text("formulation", run.formulation);
    if (run.solved())
      out.number("us_per_step", run.microseconds_per_step())
          .number("ratio", run.ratio)
          .number("iterations_per_step", run.per_step(run.iterations))
          .number("evaluations_per_step", run.per_step(run.evaluations));
    else
      out.text("failure", run.failure);
    out.end_object();
  }
  return out.end_array().end_object().str();
}

int run(const Program& program, const Options& options) {
  std::vector<NamedScene> scenes = program.scenes(0);
  // the four models of Kissel, Taves and Negrut, then spatial models with free degrees of freedom
  const std::vector<std::string> chosen{
      "uwsbel_single_pendulum", "uwsbel_double_pendulum", "uwsbel_slider_crank", "uwsbel_four_link",
      "spatial_slider_crank",   "triple_pendulum",        "open_arm_7",          "stewart_platform"};
  if (!program.names_scenes())
    std::erase_if(scenes, [&](const NamedScene& s) {
      return std::find(chosen.begin(), chosen.end(), s.scene.name) == chosen.end();
    });
  Progress progress("formulation_speed", scenes.size() * static_cast<std::size_t>(options.repetitions));
  std::vector<Run> runs;
  for (const NamedScene& scene : scenes) {
    const std::vector<Run> of_scene = measure(scene, options, progress);
    runs.insert(runs.end(), of_scene.begin(), of_scene.end());
  }
  ResultsFile file("formulation_speed", columns());
  for (const Run& run : runs) file.add(fields(run));
  program.write(file);
  fmt::print("{}", program.json() ? json(runs) : text(runs));
  return batch_exit(std::all_of(runs.begin(), runs.end(), [](const Run& r) { return r.solved(); }), true);
}

}  // namespace

}  // namespace trivium

int main(int argc, char** argv) {
  using namespace trivium;
  Program program(
      "Which set of coordinates is fastest, and does this depend on the order of the method?",
      "formulation_speed",
      "the four models of Kissel, Taves and Negrut, and spatial ones with free degrees of freedom");
  Options options;
  program.options().add_option("--step", &options.step, "Step size [s]").show_default();
  program.options().add_option("--t-end", &options.t_end, "End of the runs [s]").show_default();
  program.options()
      .add_option("--repetitions", &options.repetitions, "Number of repetitions of every run")
      .between(1, 1000)
      .show_default();
  return program.run(argc, argv, [&] { return run(program, options); });
}
