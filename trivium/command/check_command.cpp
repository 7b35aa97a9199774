/// trivium check: the parts of a scene, and the consistency of its state.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <memory>

#include "base/exit_code.hpp"
#include "formulations/printed/sparsity.hpp"
#include "trivium/command/check_report.hpp"
#include "trivium/command/commands.hpp"
#include "trivium/command/scene_argument.hpp"
#include "trivium/state_check.hpp"

namespace trivium {

namespace {

struct CheckArguments : SceneArguments {
  bool json = false;
};

int run_check(const CheckArguments& arguments) {
  const LoadedScene loaded = load(arguments);
  const Check check = check_state(loaded.scene, loaded.model);
  const CheckReport report{loaded.scene, check, augmented_sparsity(loaded.model)};
  for (const std::string& warning : check.warnings) fmt::print(stderr, "warning: {}\n", warning);
  fmt::print("{}", arguments.json ? report.json() : report.text());
  if (!check.contradictory.empty()) {
    fmt::print(stderr,
               "error: {}: the rows contradict each other, so no acceleration exists; rows that contradict "
               "earlier rows: {}\n",
               arguments.scene, fmt::join(check.contradictory, ", "));
    return exit_input_error;
  }
  require_consistent(arguments.scene, loaded.model, loaded.scene.saved);
  return exit_done;
}

}  // namespace

Command add_check_command(ProgramOptions& program) {
  auto arguments = std::make_shared<CheckArguments>();
  ProgramOptions options =
      program.add_subcommand("check", "Rank, dependent rows, residuals, energy and sparsity of a scene");
  add_scene_options(options, *arguments);
  options.add_flag("--json", &arguments->json, "JSON on stdout");
  return {options,
          [arguments] { return naming_errors(arguments->scene, [&] { return run_check(*arguments); }); }};
}

}  // namespace trivium
