#pragma once
/// Starts a program as a child process, without a shell, and says how it ended. Several threads may do so at
/// the same time: environment, limits and signals are those of the child only.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace trivium::hard {

/// A signal to a running program.
struct Kill {
  int signal;
  double after;  ///< time from the start of the program [s]
};

/// A program that is to be started, and what happens to it.
struct Command {
  std::string program;  ///< path
  std::vector<std::string> arguments;
  std::vector<std::string> environment;       ///< NAME=VALUE, added to that of this process
  std::string out_file;                       ///< file that receives stdout; empty: Ended::out
  std::optional<std::uint64_t> largest_file;  ///< no file grows beyond this [bytes]
  /// Whether a write beyond largest_file also raises SIGXFSZ, which ends a program that does not handle it. A
  /// full disk raises none.
  bool raises_at_largest_file = false;
  std::optional<Kill> kill;
  double most_seconds = 120;  ///< then it is ended by SIGKILL
};

/// How a program ended.
struct Ended {
  int exit_code = -1;    ///< -1 if a signal ended it
  int signal = 0;        ///< that ended it, or 0
  bool is_late = false;  ///< whether it was ended because it took longer than most_seconds
  std::string out, err;
  double seconds = 0;

  /// Such as "exit code 3" or "signal 6 (Aborted)".
  std::string text() const;
};

/// Starts the program and waits for its end. Throws an Error if it cannot be started.
Ended run(const Command& command);

}  // namespace trivium::hard
