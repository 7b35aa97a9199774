#pragma once
/// The subcommands of `trivium`. Each adds its options to the command line and returns what to run if it was
/// chosen.

#include <CLI/CLI.hpp>
#include <functional>

#include "base/exit_code.hpp"
#include "base/option_checks.hpp"

namespace trivium {

using Command = std::function<int()>;

Command add_solve_command(CLI::App& app);
Command add_simulate_command(CLI::App& app);
Command add_check_command(CLI::App& app);
Command add_list_command(CLI::App& app);
Command add_generate_command(CLI::App& app);

}  // namespace trivium
