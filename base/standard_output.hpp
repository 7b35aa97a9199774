#pragma once
/// Messages on stderr, and the proof that results on stdout have arrived. A full disk or a closed stdout is
/// an error of the program, not a success.

#include <functional>
#include <string>

namespace trivium {

/// Says on stderr what went wrong, and fails at nothing itself.
void complain(const std::string& message);

/// Runs a program, then makes sure that all it printed has been written: a full disk or a closed stdout is no
/// success. Gives the program's exit code, or exit_output_lost with a message on stderr.
int run_and_flush(const std::function<int()>& program);

}  // namespace trivium
