#pragma once
/// How a program ends. Errors become exit codes and messages on stderr; scenes that fail in a batch are named
/// below its table, and the worst of them decides the exit code.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "base/exit_code.hpp"

namespace trivium {

/// Runs a program and gives its exit code. An error becomes a message on stderr and the exit code of its
/// kind: input 2, all else 3. What the program printed is written, or said to be lost (run_and_flush).
int run_guarded(const std::function<int()>& program);

/// What a solver or a criterion made of a batch; a solver that failed counts more.
ExitCode batch_exit(bool all_solved, bool all_passed);

/// The lines below a table that say what could not be solved; neighbours that say the same share one.
class ErrorLines {
 public:
  /// `about`: the part of the scene's work that failed; empty for all of it.
  void add(const std::string& message, std::string_view about = {});
  std::string text() const;

 private:
  struct Line {
    std::string message, about;
  };
  std::vector<Line> lines_;
};

}  // namespace trivium
