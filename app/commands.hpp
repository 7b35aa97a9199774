#pragma once
/// The subcommands of `trivium`. Each adds its options to the command line and returns what to run if it was
/// chosen.

#include <CLI/CLI.hpp>
#include <cmath>
#include <functional>
#include <string>

namespace trivium {

using Command = std::function<int()>;

/// Accepts a finite number.
inline CLI::Validator finite_time() {
  return {[](std::string& text) {
            double t = 0;
            return CLI::detail::lexical_cast(text, t) && std::isfinite(t) ? std::string()
                                                                          : "not a finite number: " + text;
          },
          "FINITE"};
}

Command add_solve_command(CLI::App& app);
Command add_check_command(CLI::App& app);
Command add_list_command(CLI::App& app);
Command add_generate_command(CLI::App& app);

}  // namespace trivium
