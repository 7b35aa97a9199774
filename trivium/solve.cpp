/// Makes the model of a scene, lets the library assemble or solve it, and converts the answer to plain types.

#include "trivium/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bodies/rotations/euler_sequence.hpp"
#include "formulations/analysis/assemble.hpp"
#include "formulations/structured_side_by_side.hpp"
#include "scenes/format/scene_error.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/scene_state.hpp"
#include "trivium/choices.hpp"
#include "trivium/plain.hpp"
#include "trivium/scene_contents.hpp"
#include "trivium/state_check.hpp"

namespace trivium {

namespace {

Model<double> model_of(const Scene::Contents& scene) { return make_model<double>(scene.scene, scene.t); }

std::vector<std::string> named(const std::vector<int>& rows, const Mechanism<double>& mechanism) {
  std::vector<std::string> names;
  for (const int k : rows) names.push_back(mechanism.row_names[k]);
  return names;
}

std::optional<double> if_known(double x) { return std::isnan(x) ? std::nullopt : std::optional(x); }

Solution solution_of(const FormulationResult<double>& result, const SolvedState& state,
                     const Model<double>& model, const std::shared_ptr<const Names>& names) {
  const RowAnalysis& rows = state.answer.rows;
  Solution out;
  out.names = names;
  out.t = model.state.t;
  out.bodies = plain_bodies(model.state, result.solution.r_ddot, result.solution.omega_bar_dot);
  out.lambda = plain(result.solution.lambda);
  for (const Reaction<double>& reaction : result.reactions) out.reactions.push_back(plain(reaction));
  out.formulation = result.name;
  out.solver = state.solver;
  out.lambda_is_unique = rows.unique;
  out.lambda_p = plain(result.lambda_internal);
  out.charts = result.charts;
  out.lambda_error = result.estimate.lambda;
  out.acceleration_error = result.estimate.acceleration;
  out.condition = if_known(rows.kappa);
  out.dependent = named(rows.dependent, model.mechanism);
  return out;
}

/// Solves in the named formulations, or in all if the list is empty.
Solutions solve_in(const Scene::Contents& scene, const SolveSettings& settings,
                   std::vector<std::string> formulations) {
  const Model<double> model = model_of(scene);
  require_consistent(scene.source, model, scene.scene.saved);
  const SolvedState state = solve_state(
      scene.scene, model, {std::move(formulations), chart_options(settings.sequence, settings.reframe)});
  const auto names = std::make_shared<const Names>(names_of(model.mechanism));
  Solutions out;
  for (const FormulationResult<double>& result : state.answer.formulations) {
    if (!result.error.empty()) {
      out.failed.push_back(fmt::format("{}: {}", result.name, result.error));
      continue;
    }
    Solution& one = out.solved.emplace_back(solution_of(result, state, model, names));
    one.warnings = warnings_of(scene.scene, SideBySide<double>{state.answer.rows, {result}});
  }
  const Discrepancy d = state.answer.discrepancy();
  out.lambda_difference = d.lambda;
  out.r_ddot_difference = d.r_ddot;
  out.omega_bar_dot_difference = d.omega_bar_dot;
  out.lambda_bound = if_known(state.answer.lambda_bound());
  return out;
}

}  // namespace

Check check(const Scene& scene) {
  const Scene::Contents& of = scene.contents();
  return naming_errors(of.source, [&] { return check_state(of.scene, model_of(of)); });
}

Scene assemble(const Scene& scene) {
  const Scene::Contents& of = scene.contents();
  return naming_errors(of.source, [&] {
    const Model<double> model = model_of(of);
    auto assembled = std::make_shared<Scene::Contents>(of);
    set_state(assembled->scene, assemble(model.mechanism, model.state));
    return Scene(std::move(assembled));
  });
}

Solution solve(const Scene& scene, const SolveSettings& settings) {
  const Scene::Contents& of = scene.contents();
  return naming_errors(of.source, [&] {
    require_formulation(settings.formulation);
    Solutions all = solve_in(of, settings, {settings.formulation});
    if (all.solved.empty()) throw ModelError({{}, of.t}, all.failed.front());
    return std::move(all.solved.front());
  });
}

Solutions solve_in_all(const Scene& scene, const SolveSettings& settings) {
  const Scene::Contents& of = scene.contents();
  return naming_errors(of.source, [&] { return solve_in(of, settings, {}); });
}

}  // namespace trivium
