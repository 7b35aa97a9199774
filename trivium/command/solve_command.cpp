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

namespace trivium {

namespace {

struct SolveArguments : SceneArguments {
  std::string formulation = "all", sequence = "313", scalar = "double";
  bool raw_chart = false, json = false;
};

template <class Scalar>
int solve(const SolveArguments& arguments, const scenes::Scene& scene, const Model<Scalar>& model,
          const RowAnalysis& rows, const SolveOptions& options) {
  using Higher = NextPrecisionT<Scalar>;
  const auto judge = make_model(scene, Higher(arguments.t));
  const SideBySide<Scalar> result = side_by_side(model, rows, options, &judge);
  const SolveReport<Scalar> report{scene, arguments.t, arguments.scalar, model.mechanism, result};
  for (const std::string& warning : report.warnings()) fmt::print(stderr, "warning: {}\n", warning);
  fmt::print("{}", arguments.json ? report.json() : report.text());
  const bool any = std::any_of(result.formulations.begin(), result.formulations.end(),
                               [](const auto& f) { return f.error.empty(); });
  return any ? exit_done : exit_solver_failed;
}

int run_solve(const SolveArguments& arguments) {
  const LoadedScene loaded = load(arguments);
  const scenes::Scene& scene = loaded.scene;
  const Model<double>& model = loaded.model;
  if (!report_consistency(arguments, check_consistency(model.mechanism, model.state)))
    return exit_input_error;
  SolveOptions options;
  if (arguments.formulation != "all") options.formulations = {arguments.formulation};
  options.charts = {*parse_euler_sequence(arguments.sequence), !arguments.raw_chart};
  const RowAnalysis rows = analyse_rows(model);
  const auto solve_in = [&]<class Scalar>(Scalar t) {
    return solve(arguments, scene, make_model(scene, t), rows, options);
  };
  if (arguments.scalar == "double") return solve(arguments, scene, model, rows, options);
  if (arguments.scalar == "float") return solve_in(static_cast<float>(arguments.t));
  if (arguments.scalar == "quad") return solve_in(Quad(arguments.t));
  return solve_in(Real50(arguments.t));
}

}  // namespace

Command add_solve_command(ProgramOptions& program) {
  auto arguments = std::make_shared<SolveArguments>();
  ProgramOptions options = program.add_subcommand(
      "solve", "Accelerations, lambda and reactions of a scene's state, in every formulation");
  add_scene_options(options, *arguments);
  std::vector<std::string> formulations = formulation_names();
  formulations.push_back("all");
  options.add_option("--formulation", &arguments->formulation, "Which formulation")
      .one_of(formulations)
      .show_default();
  options.add_option("--sequence", &arguments->sequence, "Euler-angle sequence of r-epsilon")
      .one_of({euler_sequence_names.begin(), euler_sequence_names.end()})
      .show_default();
  options.add_flag("--no-reframe", &arguments->raw_chart,
                   "Take the raw chart of the sequence, however near its singularity");
  options.add_option("--scalar", &arguments->scalar, "Arithmetic")
      .one_of({"float", "double", "quad", "50"})
      .show_default();
  options.add_flag("--json", &arguments->json, "JSON on stdout");
  return {options, [arguments] { return naming_scene(*arguments, [&] { return run_solve(*arguments); }); }};
}

}  // namespace trivium
