/// trivium: solve, simulate, check, list and generate scenes from the command line.

#include <fmt/format.h>

#include "base/command_line.hpp"
#include "base/error.hpp"
#include "base/standard_output.hpp"
#include "scenes/format/scene_error.hpp"
#include "trivium/command/commands.hpp"

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

/// What is wrong with the first word if it should be a subcommand and is none; empty if nothing is.
std::string misuse(const CLI::App& app, int argc, char** argv) {
  const std::string word = argc > 1 ? argv[1] : "";
  if (word.starts_with('-')) return {};
  std::vector<std::string_view> names;
  for (const CLI::App* known : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (known->get_name() == word) return {};
    names.push_back(known->get_name());
  }
  const std::string found = argc > 1 ? "unknown subcommand " + scenes::in_quotes(word) : "no subcommand";
  const std::string slip = scenes::nearest(word, names);
  return fmt::format("{}; accepted: {}{}; trivium --help says more", found, scenes::list_of(names),
                     slip.empty() ? "" : fmt::format(" (did you mean {}?)", scenes::in_quotes(slip)));
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
                                                      {"simulate", add_simulate_command(app)},
                                                      {"check", add_check_command(app)},
                                                      {"list", add_list_command(app)},
                                                      {"generate", add_generate_command(app)}};
  if (const std::string message = misuse(app, argc, argv); !message.empty()) {
    complain(message);
    return exit_input_error;
  }
  return parse_and_run(app, argc, argv, [&] {
    for (const auto& [name, run] : commands)
      if (app.got_subcommand(name)) return run_named(*app.get_subcommand(name), run);
    return static_cast<int>(exit_input_error);
  });
}
