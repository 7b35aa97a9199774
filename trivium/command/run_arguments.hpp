#pragma once
/// The command-line options of a run that `simulate` and `compare` share: the integrator, its steps and
/// parameters, and charts. Options of one subcommand alone are in its own file.

#include <string>

#include "base/option_checks.hpp"
#include "simulation/simulate.hpp"
#include "trivium/command/scene_argument.hpp"

namespace trivium {

struct RunArguments : SceneArguments {
  SimulationOptions options;
  std::string sequence = "313";
  bool raw_chart = false, full_newton = false;

  /// The options of the run, with the charts and flags of the command line.
  SimulationOptions run_options() const;
};

/// Adds the shared options. `outputs` is the help text for the default of --output-step.
void add_run_options(ProgramOptions& options, RunArguments& arguments, const std::string& outputs);

/// Accepts the name of a writable SVG file, if gnuplot is installed.
OptionCheck figure_file();

/// The reason why figures cannot be drawn; empty if they can.
std::string why_no_figures();

}  // namespace trivium
