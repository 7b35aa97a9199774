#pragma once
/// The exit codes of all executables, for scripts. They distinguish a failed criterion (1), invalid usage or
/// input (2), and a failed solver or lost output (3).

namespace trivium {

/// Exit code of an executable. docs/commands.md shows these comments.
enum ExitCode : int {
  exit_done = 0,              ///< all is done
  exit_criterion_failed = 1,  ///< a criterion failed, for example a bound is exceeded
  exit_input_error = 2,       ///< usage or input is wrong; also a folder for results that does not exist
  exit_solver_failed = 3,     ///< a solver failed
  exit_output_lost = 3,       ///< results could not be written
  exit_interrupted = 130      ///< stopped by Ctrl-C or SIGTERM: 128 + SIGINT, a convention of shells
};

}  // namespace trivium
