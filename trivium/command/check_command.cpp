/// trivium check: what a scene consists of, and whether its state holds together.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <memory>
#include <optional>

#include "base/exit_code.hpp"
#include "formulations/analysis/row_analysis.hpp"
#include "formulations/analysis/tangent_system.hpp"
#include "formulations/body_state.hpp"
#include "formulations/printed/sparsity.hpp"
#include "formulations/r_omega.hpp"
#include "trivium/command/check_report.hpp"
#include "trivium/command/commands.hpp"
#include "trivium/command/scene_argument.hpp"

namespace trivium {

namespace {

struct CheckArguments : SceneArguments {
  bool json = false;
};

StateEnergy energy_of(const Mechanism<double>& mechanism, const MechanismState<double>& state) {
  using F = ROmega<double>;
  const auto body = body_kinematics(to_coordinates<F>(mechanism, state, {}));
  const std::vector<BodyMotion<double>> motion(body.begin(), body.end());
  const EffectView<double> view{mechanism.bodies, motion, state.t};
  StateEnergy e{0, mechanism.effects.potential_energy(view), mechanism.effects.power(view)};
  for (int b = 0; b < mechanism.nb(); ++b) e.kinetic += kinetic_energy(mechanism.bodies[b], state.twist[b]);
  return e;
}

int run_check(const CheckArguments& arguments) {
  const LoadedScene loaded = load(arguments);
  const auto& [mechanism, state] = loaded.model;
  const Consistency consistency = check_consistency(mechanism, state);
  // the rank is decided on the dense Jacobian; all else that is reported is sparse
  const int unknowns = 6 * mechanism.nb() + mechanism.nc();
  std::optional<RowAnalysis> rows;
  if (unknowns <= most_dense_unknowns)
    rows = analyse_rows(tangent_system(mechanism, state));
  else
    fmt::print(stderr,
               "warning: {}: rank and redundant rows are not determined: a dense analysis of {} unknowns, "
               "beyond the {} that it is done for\n",
               arguments.scene, unknowns, most_dense_unknowns);
  const StateEnergy energy = energy_of(mechanism, state);
  const std::vector<Sparsity> sparsity = augmented_sparsity(loaded.model);
  const CheckReport report{loaded.scene, arguments.t, mechanism, rows, consistency, energy, sparsity};
  fmt::print("{}", arguments.json ? report.json() : report.text());
  if (rows && !rows->contradictory.empty()) {
    fmt::print(stderr, "error: {}: no acceleration satisfies all rows: {} against the rows before\n",
               arguments.scene, fmt::join(report.contradictory(), ", "));
    return exit_input_error;
  }
  return report_consistency(arguments, consistency) ? exit_done : exit_input_error;
}

}  // namespace

Command add_check_command(ProgramOptions& program) {
  auto arguments = std::make_shared<CheckArguments>();
  ProgramOptions options =
      program.add_subcommand("check", "Rank, redundant rows, residuals, energy and sparsity of a scene");
  add_scene_options(options, *arguments);
  options.add_flag("--json", &arguments->json, "JSON on stdout");
  return {options, [arguments] { return naming_scene(*arguments, [&] { return run_check(*arguments); }); }};
}

}  // namespace trivium
