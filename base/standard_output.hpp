#pragma once
/// Error messages on stderr, and the check that all results on stdout were written. A full disk or a closed
/// stdout makes the program fail.

#include <csignal>
#include <cstdio>
#include <functional>
#include <new>
#include <string>

#include "base/exit_code.hpp"

namespace trivium {

/// The message where no message can be put together any more.
inline constexpr const char* memory_is_full =
    "error: the memory is full; run a smaller scene, ask for fewer outputs, or close other programs\n";

/// Prints "error: message" on stderr. Ignores write errors, so it never throws one.
void complain(const std::string& message);

/// Runs `program`, then flushes stdout. Returns the exit code of the program, or exit_output_lost with a
/// message on stderr if its output could not be written.
int run_and_flush(const std::function<int()>& program);

/// Calls the main part of a program. Where memory runs out it ends with a message and exit_solver_failed. A
/// file that exceeds the limit of file sizes is a write error instead of a signal that ends the program.
template <class Main>
int run_main(const Main& main) {
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return main();
  } catch (const std::bad_alloc&) {
    std::fputs(memory_is_full, stderr);
    return exit_solver_failed;
  }
}

}  // namespace trivium
