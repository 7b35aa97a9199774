#pragma once
/// The exit codes of all executables, for scripts. They distinguish a failed criterion (1), invalid usage or
/// input (2), and a failed solver or lost output (3).

namespace trivium {

/// Exit code of an executable.
enum ExitCode : int {
  exit_done = 0,
  exit_criterion_failed = 1,
  exit_input_error = 2,
  exit_solver_failed = 3,
  exit_output_lost = 3  ///< results could not be written to stdout
};

}  // namespace trivium
