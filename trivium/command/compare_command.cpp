/// trivium compare: one motion in every formulation, each integrated separately, or against another code.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>

#include "base/exit_code.hpp"
#include "base/number_text.hpp"
#include "base/progress.hpp"
#include "base/standard_output.hpp"
#include "base/whole_file.hpp"
#include "formulations/formulation_list.hpp"
#include "integrators/methods.hpp"
#include "scenes/format/scene_error.hpp"
#include "simulation/motion_against.hpp"
#include "simulation/motion_comparison.hpp"
#include "simulation/motion_csv.hpp"
#include "simulation/motion_warnings.hpp"
#include "trivium/command/against_report.hpp"
#include "trivium/command/commands.hpp"
#include "trivium/command/compare_report.hpp"
#include "trivium/command/run_arguments.hpp"
#include "trivium/simulation_options.hpp"
#include "trivium/state_check.hpp"

namespace trivium {

namespace {

namespace fs = std::filesystem;

struct CompareArguments : RunArguments {
  std::string formulations = "all", out, against;
  std::vector<std::string> map;
  bool plot = false, json = false;
};

/// The names in a list separated by commas; no names for "all".
std::vector<std::string> formulations_in(const std::string& text) {
  if (text == "all") return {};
  std::vector<std::string> names;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    std::string name = text.substr(from, comma - from);
    name.erase(0, name.find_first_not_of(' '));
    name.erase(name.find_last_not_of(' ') + 1);
    names.push_back(std::move(name));
    from = comma + 1;
  }
  return names;
}

/// The formulations to compare. Prints a warning for each one that the integrator cannot be used with.
std::vector<ComparedFormulation> formulations_of(const CompareArguments& arguments) {
  const std::vector<std::string> asked = formulations_in(arguments.formulations);
  const std::string& integrator = arguments.options.integrator;
  std::vector<ComparedFormulation> all = formulations_to_compare(asked, integrator);
  for (const std::string& name : asked.empty() ? formulation_names() : asked)
    if (std::none_of(all.begin(), all.end(), [&](const auto& one) { return one.name == name; }))
      fmt::print(stderr, "warning: the formulation {} is left out: the method {} does not support it\n", name,
                 integrator);
  return all;
}

/// Writes every motion, the comparison and its figure to the folder of --out.
void write_files(const CompareArguments& arguments, const CompareReport& report) {
  const fs::path folder(arguments.out);
  const MotionComparison& comparison = report.comparison;
  const bool has_raw_lambda = integrators::find_method(arguments.options.integrator)->has_raw_lambda;
  for (std::size_t f = 0; f < comparison.runs.size(); ++f) {
    MotionCsv csv(report.mechanism, has_raw_lambda, folder / (comparison.runs[f].formulation + ".csv"));
    for (const MotionSample& sample : comparison.samples[f]) csv.add(sample);
    csv.keep();
  }
  write_whole(folder / "compare.csv", report.csv());
  if (arguments.plot && !comparison.instants.empty()) report.plot(folder / "compare.svg");
}

int run_compare(const CompareArguments& arguments) {
  if (const std::string why = arguments.plot ? why_no_figures() : ""; !why.empty())
    throw Error(ErrorKind::input, fmt::format("--plot: {}", why));
  ComparisonOptions options;
  options.run = arguments.run_options();
  const LoadedScene loaded = load(arguments);
  const Model<double>& model = loaded.model;
  require_consistent(arguments.scene, model, loaded.scene.saved);
  if (!arguments.out.empty())
    fs::create_directories(arguments.out);  // an invalid folder fails before the runs
  const std::vector<ComparedFormulation> formulations = formulations_of(arguments);
  constexpr std::size_t ticks = 1000;
  Progress progress("comparing", ticks);
  std::size_t shown = 0;
  options.progress = [&](double share) {
    for (; static_cast<double>(shown) < share * ticks; ++shown) progress.step();
  };
  const MotionComparison comparison = compare_motion(formulations, model, options);
  for (const ComparedRun& run : comparison.runs)
    if (run.error.empty())
      for (const std::string& warning : warnings_of(run.report))
        fmt::print(stderr, "warning: {}: {}\n", run.formulation, warning);
  const CompareReport report{model.mechanism, model.state.t, options.run, comparison};
  fmt::print("{}", arguments.json ? report.json() : report.text());
  for (const ComparedRun& run : comparison.runs)
    if (!run.error.empty()) complain(fmt::format("{}: {}: {}", arguments.scene, run.formulation, run.error));
  if (!arguments.out.empty()) write_files(arguments, report);
  if (!comparison.complete()) return exit_solver_failed;
  return comparison.holds_along() && comparison.holds_at_states() ? exit_done : exit_criterion_failed;
}

/// The map from their column names to ours, from words THEIRS=OURS.
std::map<std::string, std::string> names_in(const std::vector<std::string>& words) {
  std::map<std::string, std::string> names;
  for (const std::string& word : words) {
    const std::size_t equals = word.rfind('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == word.size())
      throw Error(
          ErrorKind::input,
          fmt::format(
              "--map: found \"{}\"; accepted: THEIRS=OURS, the names of a column in the file and here",
              word));
    if (!names.emplace(word.substr(0, equals), word.substr(equals + 1)).second)
      throw Error(ErrorKind::input, fmt::format("--map: \"{}\" is named twice", word.substr(0, equals)));
  }
  return names;
}

int run_against(const CompareArguments& arguments) {
  const LoadedScene loaded = load(arguments);
  const Model<double>& model = loaded.model;
  require_consistent(arguments.scene, model, loaded.scene.saved);
  const OtherMotion other =
      read_motion(arguments.against, names_in(arguments.map), motion_columns(model.mechanism, false));
  if (!other.unknown.empty())
    fmt::print(stderr, "warning: {}: {} with unknown names, not compared; the first is {}\n",
               arguments.against, counted(other.unknown.size(), "column", "columns"),
               scenes::in_quotes(other.unknown.front()));
  if (!arguments.out.empty()) fs::create_directories(arguments.out);
  const SimulationOptions options = arguments.run_options();
  if (options.output_step || options.end != SimulationOptions{}.end)
    throw Error(ErrorKind::input,
                "--against compares at the times of the file; leave out --t-end and --output-step");
  const auto formulations =
      formulations_to_compare(formulations_in(arguments.formulations), options.integrator, 1);
  const MotionAgainst comparison = compare_against(formulations, model, other, options);
  const AgainstReport report{model.mechanism.name, arguments.against, other, options, comparison};
  fmt::print("{}", arguments.json ? report.json() : report.text());
  for (const ComparedRun& run : comparison.runs)
    if (!run.error.empty()) complain(fmt::format("{}: {}: {}", arguments.scene, run.formulation, run.error));
  if (!arguments.out.empty()) write_whole(fs::path(arguments.out) / "against.csv", report.csv());
  if (!comparison.complete()) return exit_solver_failed;
  return comparison.holds() ? exit_done : exit_criterion_failed;
}

/// Accepts an existing folder, or a name for a new one.
OptionCheck folder() {
  return {[](const std::string& text) {
            std::error_code error;
            const fs::path path(text);
            if (fs::exists(path, error) && !fs::is_directory(path, error))
              return fmt::format("{} is not a folder; accepted: a folder, or a name for a new folder", text);
            return std::string();
          },
          "DIR"};
}

}  // namespace

Command add_compare_command(ProgramOptions& program) {
  auto arguments = std::make_shared<CompareArguments>();
  ProgramOptions options = program.add_subcommand(
      "compare",
      "One motion in every formulation: lambda, positions and accelerations side by side through time");
  add_scene_options(options, *arguments);
  options
      .add_option("--formulations", &arguments->formulations,
                  fmt::format("Formulations to compare: all, or a comma-separated list of {}",
                              fmt::join(formulation_names(), ",")))
      .show_default();
  add_run_options(options, *arguments, "a hundredth of the run");
  const ProgramOption out =
      options
          .add_option("--out", &arguments->out, "Write every motion and the comparison as CSV to this folder")
          .check(folder());
  const ProgramOption plot =
      options.add_flag("--plot", &arguments->plot, "Draw the comparison to compare.svg in that folder")
          .needs(out);
  const ProgramOption against =
      options
          .add_option(
              "--against", &arguments->against,
              "Compare with a motion of another program (a CSV file) instead, column by column at its times")
          .excludes(plot);
  options
      .add_option("--map", &arguments->map,
                  "With --against: the name that a column of the file has here; may be repeated")
      .may_repeat("THEIRS=OURS")
      .needs(against);
  options.add_flag("--json", &arguments->json, "JSON on stdout");
  return {options, [arguments] {
            return naming_errors(arguments->scene, [&] {
              return arguments->against.empty() ? run_compare(*arguments) : run_against(*arguments);
            });
          }};
}

}  // namespace trivium
