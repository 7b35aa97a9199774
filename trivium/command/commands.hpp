#pragma once
/// The subcommands of `trivium`, one source file each. Every function below adds the options of its
/// subcommand to the command line and returns the function that runs the subcommand.

#include <functional>

#include "base/program_options.hpp"

namespace trivium {

struct Command {
  ProgramOptions options;
  std::function<int()> run;  ///< runs the subcommand; returns the exit code
};

Command add_solve_command(ProgramOptions& program);
Command add_simulate_command(ProgramOptions& program);
Command add_compare_command(ProgramOptions& program);
Command add_check_command(ProgramOptions& program);
Command add_list_command(ProgramOptions& program);
Command add_generate_command(ProgramOptions& program);

}  // namespace trivium
