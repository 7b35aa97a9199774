/// trivium solve: accelerations, lambda and reactions of a scene's state, in every formulation.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "base/exit_code.hpp"
#include "bodies/numbers/quad.hpp"
#include "bodies/numbers/real50.hpp"
#include "bodies/numbers/scalar.hpp"
#include "bodies/rotations/euler_sequence.hpp"
#include "formulations/analysis/row_analysis.hpp"
#include "formulations/formulation_list.hpp"
#include "formulations/side_by_side.hpp"
#include "scenes/make_mechanism.hpp"
#include "trivium/command/commands.hpp"
#include "trivium/command/scene_argument.hpp"
#include "trivium/command/solve_report.hpp"
#include "trivium/state_check.hpp"

namespace trivium {

namespace {

struct SolveArguments : SceneArguments {
  std::string formulation = "all", sequence = "313", scalar = "double";
  bool raw_chart = false, json = false;
};

/// Prints warnings and the report of a solution. Returns the exit code: failure if no formulation solved.
template <class Scalar>
int report(const SolveArguments& arguments, const LoadedScene& loaded, const char* solver,
           const Mechanism<Scalar>& mechanism, const SideBySide<Scalar>& answer) {
  const SolveReport<Scalar> report{loaded.scene, loaded.model.state.t, arguments.scalar, solver, mechanism,
                                   answer};
  for (const std::string& warning : warnings_of(loaded.scene, answer))
    fmt::print(stderr, "warning: {}\n", warning);
  fmt::print("{}", arguments.json ? report.json() : report.text());
  const bool any = std::any_of(answer.formulations.begin(), answer.formulations.end(),
                               [](const auto& f) { return f.error.empty(); });
  return any ? exit_done : exit_solver_failed;
}

/// Solves the printed system in another Scalar than double.
template <class Scalar>
int solve_in(const SolveArguments& arguments, const LoadedScene& loaded, const SolveOptions& options) {
  using Higher = NextPrecisionT<Scalar>;
  const double t = loaded.model.state.t;
  const auto rows = analyse_rows(loaded.model);
  const auto model = make_model(loaded.scene, static_cast<Scalar>(t));
  const auto judge = make_model(loaded.scene, static_cast<Higher>(t));
  return report(arguments, loaded, "printed", model.mechanism, side_by_side(model, rows, options, &judge));
}

int run_solve(const SolveArguments& arguments) {
  const LoadedScene loaded = load(arguments);
  require_consistent(arguments.scene, loaded.model, loaded.scene.saved);
  SolveOptions options;
  if (arguments.formulation != "all") options.formulations = {arguments.formulation};
  options.charts = {*parse_euler_sequence(arguments.sequence), !arguments.raw_chart};
  if (arguments.scalar == "double") {
    const auto& [solver, answer] = solve_state(loaded.scene, loaded.model, options);
    return report(arguments, loaded, solver, loaded.model.mechanism, answer);
  }
  if (arguments.scalar == "float") return solve_in<float>(arguments, loaded, options);
  if (arguments.scalar == "quad") return solve_in<Quad>(arguments, loaded, options);
  return solve_in<Real50>(arguments, loaded, options);
}

}  // namespace

Command add_solve_command(ProgramOptions& program) {
  auto arguments = std::make_shared<SolveArguments>();
  ProgramOptions options = program.add_subcommand(
      "solve", "Accelerations, lambda and reactions at the state of a scene, in every formulation");
  add_scene_options(options, *arguments);
  std::vector<std::string> formulations = formulation_names();
  formulations.push_back("all");
  options
      .add_option("--formulation", &arguments->formulation, "Formulation of the equations of motion, or all")
      .one_of(formulations)
      .show_default();
  options.add_option("--sequence", &arguments->sequence, "Euler-angle sequence of r-epsilon")
      .one_of({euler_sequence_names.begin(), euler_sequence_names.end()})
      .show_default();
  options.add_flag("--no-reframe", &arguments->raw_chart,
                   "Keep the chart of the Euler-angle sequence, even near its singularity");
  options
      .add_option("--scalar", &arguments->scalar, "Arithmetic: quad has 113 bits, 50 has 50 decimal digits")
      .one_of({"float", "double", "quad", "50"})
      .show_default();
  options.add_flag("--json", &arguments->json, "JSON on stdout");
  return {options,
          [arguments] { return naming_errors(arguments->scene, [&] { return run_solve(*arguments); }); }};
}

}  // namespace trivium
