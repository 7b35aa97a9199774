/// trivium simulate: a scene's motion in one formulation by one method.

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <new>
#include <stdexcept>

#include "base/exit_code.hpp"
#include "base/standard_output.hpp"
#include "formulations/formulation_list.hpp"
#include "scenes/format/scene_file.hpp"
#include "simulation/motion_warnings.hpp"
#include "simulation/simulate.hpp"
#include "trivium/command/commands.hpp"
#include "trivium/command/interrupt.hpp"
#include "trivium/command/motion_output.hpp"
#include "trivium/command/motion_report.hpp"
#include "trivium/command/run_arguments.hpp"
#include "trivium/run_end.hpp"
#include "trivium/state_check.hpp"

namespace trivium {

namespace {

struct SimulateArguments : RunArguments {
  std::string out, plot, save_end;
  std::vector<double> baumgarte;
  bool no_projection = false, verify = false, json = false;
};

/// enough for smooth curves: a figure is about 600 points wide
constexpr int output_steps_of_a_figure = 500;

/// Writes the scene at the end of the run to the file of --save-end. Returns false, with a message, on
/// failure.
bool save_end(const SimulateArguments& arguments, scenes::Scene& scene, const RunEnd& end) {
  set_end(scene, end);
  try {
    scenes::write_scene_file(arguments.save_end, scene);
    return true;
  } catch (const Error& error) {
    complain(error.what());
    return false;
  }
}

int run_simulate(const SimulateArguments& arguments) {
  SimulationOptions options = arguments.run_options();
  options.projects = !arguments.no_projection && arguments.baumgarte.empty();
  if (arguments.verify && !options.step)
    throw Error(ErrorKind::input, "--verify: the steps follow tolerances; accepted: with --step");
  if (!arguments.baumgarte.empty()) options.baumgarte = {arguments.baumgarte[0], arguments.baumgarte[1]};
  if (!arguments.save_end.empty() &&
      (arguments.save_end == arguments.out || arguments.save_end == arguments.plot))
    throw Error(ErrorKind::input,
                fmt::format("--save-end: {} is written by another option; accepted: a different file",
                            arguments.save_end));
  LoadedScene loaded = load(arguments);
  const Model<double>& model = loaded.model;
  const double t = model.state.t;
  if (!arguments.plot.empty() && !options.output_step && options.end > t)
    options.output_step = (options.end - t) / output_steps_of_a_figure;
  options.from = loaded.scene.saved;
  require_consistent(arguments.scene, model, options.from, options.formulation);
  const MotionReport of{model.mechanism, t, options};
  MotionOutput output(model.mechanism, t, options, arguments.out, arguments.plot);
  catch_interrupts();
  try {
    const SimulationReport report = simulate(model, options, output);
    std::vector<ErrorByHalving> verified;
    if (arguments.verify && report.complete) verified = verify_steps(model, options);
    for (const std::string& warning : warnings_of(report)) fmt::print(stderr, "warning: {}\n", warning);
    for (const ErrorByHalving& e : verified)
      if (!e.is_reliable())
        fmt::print(
            stderr,
            "warning: the error of {} falls with order {:.2f} as the step is halved, not with the method's "
            "order {}: this error estimate is not reliable; take smaller steps\n",
            e.quantity, *e.order, e.expected_order);
    fmt::print("{}", arguments.json ? of.json(report, verified) : of.text(report, verified));
    bool is_kept = output.keep();
    if (!arguments.save_end.empty()) is_kept = save_end(arguments, loaded.scene, report.end) && is_kept;
    if (!is_kept) return exit_output_lost;
    if (report.complete) return exit_done;
    fmt::print(stderr, "interrupted at t = {}\n", report.reached);
    output.say_what_is_kept();
    return exit_interrupted;
  } catch (const std::bad_alloc&) {
    std::fputs(memory_is_full, stderr);
    if (output.keep()) output.say_what_is_kept();
    return exit_solver_failed;
  } catch (const std::runtime_error& error) {
    complain(name_source(arguments.scene, error.what()));
    const auto* known = dynamic_cast<const Error*>(&error);
    if (known && known->kind() == ErrorKind::input) return exit_input_error;
    // an error of the model or of the method: the outputs before it and the last state are kept
    if (arguments.json) fmt::print("{}", of.failure_json(output.last(), error.what()));
    if (output.keep()) output.say_what_is_kept();
    return exit_solver_failed;
  }
}

}  // namespace

Command add_simulate_command(ProgramOptions& program) {
  auto arguments = std::make_shared<SimulateArguments>();
  SimulationOptions& run = arguments->options;
  ProgramOptions options = program.add_subcommand(
      "simulate", "Motion of a scene in one formulation by one method, with reactions and lambda");
  add_scene_options(options, *arguments);
  options.add_option("--formulation", &run.formulation, "Formulation of the equations of motion")
      .one_of(formulation_names())
      .show_default();
  add_run_options(options, *arguments,
                  fmt::format("only start and end; with --plot {} outputs", output_steps_of_a_figure + 1));
  options.add_option("--out", &arguments->out, "Write the motion to this CSV file").check(writable_file());
  options.add_option("--plot", &arguments->plot, "Draw the outputs to this SVG file").check(figure_file());
  options
      .add_option(
          "--save-end", &arguments->save_end,
          "Write the scene at the end of the run to this file; another run can continue from this file")
      .check(writable_file());
  options.add_flag("--verify", &arguments->verify,
                   "With --step: repeat the run with half and a quarter of the step, and report the errors");
  const ProgramOption no_projection =
      options.add_flag("--no-projection", &arguments->no_projection,
                       "Do not project onto the constraints: their drift remains");
  options
      .add_option("--baumgarte", &arguments->baumgarte,
                  "Baumgarte stabilisation Phi'' + 2 alpha Phi' + beta^2 Phi = 0 instead of projection [1/s]")
      .values({"ALPHA", "BETA"})
      .check(number_from_zero())
      .excludes(no_projection);
  options.add_flag("--json", &arguments->json, "JSON on stdout");
  return {options,
          [arguments] { return naming_errors(arguments->scene, [&] { return run_simulate(*arguments); }); }};
}

}  // namespace trivium
