/// trivium simulate: a scene's motion in one formulation by one method.

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "base/command_line.hpp"
#include "base/exit_code.hpp"
#include "base/standard_output.hpp"
#include "bodies/rotations/euler_sequence.hpp"
#include "formulations/formulation_list.hpp"
#include "integrators/methods.hpp"
#include "simulation/simulate.hpp"
#include "trivium/command/commands.hpp"
#include "trivium/command/interrupt.hpp"
#include "trivium/command/motion_output.hpp"
#include "trivium/command/motion_report.hpp"
#include "trivium/command/scene_argument.hpp"

namespace trivium {

namespace {

struct SimulateArguments : SceneArguments {
  SimulationOptions options;
  std::string sequence = "313", out, plot;
  std::vector<double> baumgarte;
  bool raw_chart = false, no_projection = false, full_newton = false, json = false;
};

constexpr int outputs_of_a_figure = 500;

int run_simulate(const SimulateArguments& given) {
  SimulateArguments arguments = given;
  SimulationOptions& options = arguments.options;
  options.charts = {*parse_euler_sequence(arguments.sequence), !arguments.raw_chart};
  if (arguments.full_newton) options.parameters.full_newton = true;
  options.projects = !arguments.no_projection && arguments.baumgarte.empty();
  if (!arguments.plot.empty() && !options.output_step && options.end > arguments.t)
    options.output_step = (options.end - arguments.t) / outputs_of_a_figure;
  if (!arguments.baumgarte.empty()) options.baumgarte = {arguments.baumgarte[0], arguments.baumgarte[1]};
  const Model<double> model = load(arguments).model;
  if (!report_consistency(arguments, check_consistency(model.mechanism, model.state)))
    return exit_input_error;
  const MotionReport of{model.mechanism, arguments.t, options};
  MotionOutput output(model.mechanism, arguments.t, options, arguments.out, arguments.plot);
  catch_interrupts();
  try {
    const SimulationReport report = simulate(model, options, output);
    for (const std::string& warning : warnings_of(report)) fmt::print(stderr, "warning: {}\n", warning);
    fmt::print("{}", arguments.json ? of.json(report) : of.text(report));
    const bool is_kept = output.keep();
    if (report.complete) return is_kept ? exit_done : exit_output_lost;
    fmt::print(stderr, "interrupted at t = {}\n", report.reached);
    if (is_kept) output.say_what_is_kept();
    return exit_interrupted;
  } catch (const integrators::UsageError& error) {
    complain(error.what());
    return exit_input_error;
  } catch (const std::runtime_error& error) {
    // of the model or of the method; what was computed until then is kept
    complain(name_source(arguments.scene, error.what()));
    if (arguments.json) fmt::print("{}", of.failure_json(output.last(), error.what()));
    if (output.keep()) output.say_what_is_kept();
    return exit_solver_failed;
  }
}

/// Accepts a figure's file, where there is a program to draw it.
OptionCheck figure_file() {
  return {[](const std::string& text) {
            if (!text.ends_with(".svg"))
              return fmt::format("found {}; accepted: a file name ending in .svg", text);
            if (std::string why = why_not_writable(text); !why.empty()) return why;
            return std::system("command -v gnuplot >/dev/null 2>&1") == 0
                       ? std::string()
                       : std::string("gnuplot, which draws it, is not installed (Debian: gnuplot-nox)");
          },
          "FILE.svg"};
}

}  // namespace

Command add_simulate_command(ProgramOptions& program) {
  auto arguments = std::make_shared<SimulateArguments>();
  SimulationOptions& run = arguments->options;
  ProgramOptions options = program.add_subcommand(
      "simulate", "A scene's motion in one formulation by one method, its reactions and lambda");
  add_scene_options(options, *arguments);
  options.add_option("--formulation", &run.formulation, "Which formulation")
      .one_of(formulation_names())
      .show_default();
  options.add_option("--integrator", &run.integrator, "Which method")
      .one_of(integrators::method_names())
      .show_default();
  options.add_option("--t-end", &run.end, "The end of the run [s]").check(finite_time()).show_default();
  const ProgramOption step =
      options.add_option("--step", &run.step, "Steps of this length [s] instead of tolerances")
          .check(positive_number());
  options.add_option("--rtol", &run.tolerances.rtol, "Relative tolerance of a step")
      .check(positive_number())
      .excludes(step)
      .show_default();
  options.add_option("--atol", &run.tolerances.atol, "Absolute tolerance of a step")
      .check(positive_number())
      .excludes(step)
      .show_default();
  options
      .add_option("--output-step", &run.output_step,
                  fmt::format("Time between outputs [s] (default: start and end; with --plot {} of them)",
                              outputs_of_a_figure))
      .check(positive_number());
  options.add_option("--out", &arguments->out, "Write the motion to this CSV file").check(writable_file());
  options.add_option("--plot", &arguments->plot, "Draw the outputs to this SVG file").check(figure_file());
  const ProgramOption no_projection = options.add_flag("--no-projection", &arguments->no_projection,
                                                       "Leave drift off the constraints as it is");
  options
      .add_option("--baumgarte", &arguments->baumgarte,
                  "Phi'' + 2 alpha Phi' + beta^2 Phi = 0 instead of projection [1/s]")
      .values({"ALPHA", "BETA"})
      .check(number_from_zero())
      .excludes(no_projection);
  options.add_option(
      "--order", &run.parameters.order,
      "Of bdf, 1 to 5 (default 2); of arkode-erk, 2 to 8, and arkode-dirk, 2 to 5 (default 5)");
  options.add_option("--rho", &run.parameters.rho,
                     "Of generalized-alpha: spectral radius at infinity, 0 to 1 (default 0.8)");
  options.add_option("--alpha", &run.parameters.alpha, "Of hht, -1/3 to 0 (default -0.2)");
  options.add_flag("--full-newton", &arguments->full_newton,
                   "Of implicit methods: a matrix every iteration, not every step");
  options.add_option("--sequence", &arguments->sequence, "Euler-angle sequence of r-epsilon")
      .one_of({euler_sequence_names.begin(), euler_sequence_names.end()})
      .show_default();
  options.add_flag("--no-reframe", &arguments->raw_chart,
                   "Take the raw chart of the sequence, and fail where it is singular");
  options.add_flag("--json", &arguments->json, "JSON on stdout");
  return {options,
          [arguments] { return naming_scene(*arguments, [&] { return run_simulate(*arguments); }); }};
}

}  // namespace trivium
