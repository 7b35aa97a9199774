#pragma once
/// The options of a run through time, which `simulate` and `compare` have alike: the method, its steps, its
/// parameters, and charts. What the two have of their own stands with them.

#include <string>

#include "base/option_checks.hpp"
#include "simulation/simulate.hpp"
#include "trivium/command/scene_argument.hpp"

namespace trivium {

struct RunArguments : SceneArguments {
  SimulationOptions options;
  std::string sequence = "313";
  bool raw_chart = false, full_newton = false;

  /// The options as the words of the command line make them.
  SimulationOptions run_options() const;
};

/// `outputs` says what there is without --output-step.
void add_run_options(ProgramOptions& options, RunArguments& arguments, const std::string& outputs);

/// Accepts a figure's file, where there is a program to draw it.
OptionCheck figure_file();

/// What keeps figures from being drawn; empty if nothing does.
std::string why_no_figures();

}  // namespace trivium
