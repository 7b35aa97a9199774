#pragma once
/// The exit codes that every executable keeps to: what a script may conclude from a run. A criterion that
/// failed (1) is told from a file that could not be read (2) and from a solver that failed (3).

namespace trivium {

enum ExitCode : int {
  exit_done = 0,
  exit_criterion_failed = 1,
  exit_input_error = 2,
  exit_solver_failed = 3,
  exit_output_lost = 3  ///< what was computed could not be written to stdout
};

}  // namespace trivium
