#pragma once
/// How a program ends. `run_guarded` turns errors into a message on stderr and an exit code. A program that
/// works through a batch of scenes lists the failed scenes below its table (`ErrorLines`) and derives one
/// exit code from the whole batch (`batch_exit`).

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "base/exit_code.hpp"

namespace trivium {

/// Runs `program` by run_and_flush and returns its exit code. An Error becomes a message on stderr and an
/// exit code: 2 for ErrorKind::input and for file system errors, 3 for the other kinds.
int run_guarded(const std::function<int()>& program);

/// The exit code of a batch: 3 if a scene could not be solved, else 1 if a criterion failed, else 0.
ExitCode batch_exit(bool all_solved, bool all_passed);

/// The error lines below a table. Consecutive errors with the same message share one line.
class ErrorLines {
 public:
  /// `about` names the part of the work that failed, e.g. a formulation; empty if all of the scene failed.
  void add(const std::string& message, std::string_view about = {});
  std::string text() const;

 private:
  struct Line {
    std::string message, about;
  };
  std::vector<Line> lines_;
};

}  // namespace trivium
