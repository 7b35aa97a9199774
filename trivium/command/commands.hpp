#pragma once
/// The subcommands of `trivium`, one file each. A file adds its subcommand's options to the command line and
/// says what runs where the command line names it.

#include <functional>

#include "base/program_options.hpp"

namespace trivium {

struct Command {
  ProgramOptions options;
  std::function<int()> run;  ///< gives the exit code
};

Command add_solve_command(ProgramOptions& program);
Command add_simulate_command(ProgramOptions& program);
Command add_compare_command(ProgramOptions& program);
Command add_check_command(ProgramOptions& program);
Command add_list_command(ProgramOptions& program);
Command add_generate_command(ProgramOptions& program);

}  // namespace trivium
