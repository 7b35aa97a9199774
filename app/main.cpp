/// trivium: solve, check, list and generate scenes from the command line.

#include <fmt/format.h>

#include "app/commands.hpp"
#include "bodies/error.hpp"
#include "validation/program.hpp"

namespace trivium {

namespace {

/// A solver's message carries the scene as the command line names it.
int run_named(const CLI::App& subcommand, const Command& run) {
  const CLI::Option* scene = subcommand.get_option_no_throw("SCENE");
  try {
    return run();
  } catch (const ModelError& error) {
    if (!scene) throw;
    throw ModelError(name_source(scene->as<std::string>(), error.what()));
  }
}

}  // namespace

}  // namespace trivium

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
  return parse_and_run(app, argc, argv, [&] {
    for (const auto& [name, run] : commands)
      if (app.got_subcommand(name)) return run_named(*app.get_subcommand(name), run);
    return static_cast<int>(exit_input_error);
  });
}
