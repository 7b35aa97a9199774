#pragma once
/// Error messages on stderr, and the check that all results on stdout were written. A full disk or a closed
/// stdout makes the program fail.

#include <functional>
#include <string>

namespace trivium {

/// Prints "error: message" on stderr. Ignores write errors, so it never throws one.
void complain(const std::string& message);

/// Runs `program`, then flushes stdout. Returns the exit code of the program, or exit_output_lost with a
/// message on stderr if its output could not be written.
int run_and_flush(const std::function<int()>& program);

}  // namespace trivium
