/// trivium generate: writes scene files of regular mechanisms of any size.

#include <fmt/format.h>

#include <limits>
#include <memory>

#include "base/error.hpp"
#include "base/exit_code.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/format/scene_file.hpp"
#include "scenes/generators.hpp"
#include "trivium/command/commands.hpp"

namespace trivium {

namespace {

struct GenerateArguments {
  std::string kind, out;
  int n = 1;
  std::uint64_t seed = 1;
};

scenes::Scene generate(const GenerateArguments& arguments) {
  if (arguments.kind == "chain") return scenes::chain(arguments.n);
  if (arguments.kind == "ladder") return scenes::ladder(arguments.n);
  if (arguments.kind == "ring") {
    if (arguments.n < 3)
      throw Error(ErrorKind::input,
                  fmt::format("N: found {}; accepted: at least 3 bars for a ring", arguments.n));
    return scenes::ring(arguments.n);
  }
  if (arguments.kind == "hub") return scenes::hub(arguments.n);
  return scenes::tree(arguments.n, arguments.seed);
}

int run_generate(const GenerateArguments& arguments) {
  const scenes::Scene scene = generate(arguments);
  if (arguments.out.empty())
    fmt::print("{}", scenes::write_scene(scene));
  else
    scenes::write_scene_file(arguments.out, scene);
  return exit_done;
}

}  // namespace

Command add_generate_command(ProgramOptions& program) {
  auto arguments = std::make_shared<GenerateArguments>();
  ProgramOptions options = program.add_subcommand(
      "generate", "Write a chain, ladder, tree, ring or hub of size N as a scene file");
  options.add_option("KIND", &arguments->kind, "Kind of mechanism")
      .required()
      .one_of({"chain", "ladder", "tree", "ring", "hub"});
  options.add_option("N", &arguments->n, "Number of bars (at least 3 for a ring), or of loops of a ladder")
      .required()
      .between(1, 100000);
  options.add_option("--seed", &arguments->seed, "Seed of the random tree")
      .check(whole_number(std::numeric_limits<std::uint64_t>::max()))
      .show_default();
  options.add_option("--out", &arguments->out, "Write to this file instead of stdout").check(writable_file());
  return {options, [arguments] { return run_generate(*arguments); }};
}

}  // namespace trivium
