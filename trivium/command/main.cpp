/// trivium: solve, simulate, compare, check, list and generate scenes from the command line.

#include <fmt/format.h>

#include "base/exit_code.hpp"
#include "base/standard_output.hpp"
#include "scenes/format/scene_error.hpp"
#include "trivium/command/commands.hpp"

namespace trivium {

namespace {

/// The error message if the first word is missing or no subcommand; empty if it is a subcommand or an option.
std::string misuse(const std::vector<Command>& commands, int argc, char** argv) {
  const std::string word = argc > 1 ? argv[1] : "";
  if (word.starts_with('-')) return {};
  std::vector<std::string_view> names;
  for (const Command& known : commands) {
    if (known.options.name() == word) return {};
    names.push_back(known.options.name());
  }
  const std::string found = argc > 1 ? "unknown subcommand " + scenes::in_quotes(word) : "no subcommand";
  const std::string slip = scenes::nearest(word, names);
  return fmt::format("{}; accepted: {}{}; see trivium --help", found, scenes::list_of(names),
                     slip.empty() ? "" : fmt::format(" (did you mean {}?)", scenes::in_quotes(slip)));
}

}  // namespace

}  // namespace trivium

int main(int argc, char** argv) {
  using namespace trivium;
  return run_main([&]() -> int {
    ProgramOptions program(
        "Constrained rigid-multibody dynamics in three formulations on one constraint library", "trivium");
    program.describe_help("Print this help and exit");
    const std::vector<Command> commands{add_solve_command(program),   add_simulate_command(program),
                                        add_compare_command(program), add_check_command(program),
                                        add_list_command(program),    add_generate_command(program)};
    if (const std::string message = misuse(commands, argc, argv); !message.empty()) {
      complain(message);
      return exit_input_error;
    }
    return program.run(argc, argv, [&] {
      for (const Command& command : commands)
        if (command.options.is_chosen()) return command.run();
      return static_cast<int>(exit_input_error);
    });
  });
}
