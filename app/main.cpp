/// trivium: solve, check, list and generate scenes from the command line.

#include <fmt/format.h>

#include "app/commands.hpp"
#include "validation/catalogue.hpp"

int main(int argc, char** argv) {
  using namespace trivium;
  CLI::App app{"Constrained rigid-multibody dynamics in three formulations on one constraint library",
               "trivium"};
  app.set_version_flag("--version", "trivium " TRIVIUM_VERSION);
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.require_subcommand(1);
  const std::pair<const char*, Command> commands[] = {{"solve", add_solve_command(app)},
                                                      {"check", add_check_command(app)},
                                                      {"list", add_list_command(app)},
                                                      {"generate", add_generate_command(app)}};
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_done : exit_input_error;
  }
  return run_guarded([&] {
    for (const auto& [name, run] : commands)
      if (app.got_subcommand(name)) return run();
    return static_cast<int>(exit_input_error);
  });
}
