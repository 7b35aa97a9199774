/// The analysis of a state behind `trivium check` and trivium::check: residuals, rank and energy. Its
/// function check_state is declared in state_check.hpp.

#include <fmt/format.h>

#include <algorithm>

#include "formulations/analysis/consistency.hpp"
#include "formulations/analysis/magnitude_bounds.hpp"
#include "formulations/analysis/tangent_system.hpp"
#include "formulations/body_state.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/structured_side_by_side.hpp"
#include "trivium/plain.hpp"
#include "trivium/state_check.hpp"

namespace trivium {

namespace {

void add_energy(const Model<double>& model, Check& out) {
  const auto& [mechanism, state] = model;
  const auto body = body_kinematics(to_coordinates<ROmega<double>>(mechanism, state, {}));
  const std::vector<BodyMotion<double>> motion(body.begin(), body.end());
  const EffectView<double> view{mechanism.bodies, motion, state.t};
  out.potential_energy = mechanism.effects.potential_energy(view);
  out.effect_power = mechanism.effects.power(view);
  for (int b = 0; b < mechanism.nb(); ++b)
    out.kinetic_energy += kinetic_energy(mechanism.bodies[b], state.twist[b]);
}

}  // namespace

Check check_state(const scenes::Scene& scene, const Model<double>& model) {
  const auto& [mechanism, state] = model;
  const Consistency consistency = check_consistency(mechanism, state);
  Check out;
  out.scene = mechanism.name;
  out.names = names_of(mechanism);
  out.t = state.t;
  const bool is_dense = !is_beyond_dense(mechanism);
  out.solver = is_dense ? "printed" : "structured";
  RowAnalysis rows;
  if (is_dense || consistency.holds()) {
    if (is_dense) {
      TangentSystem system = tangent_system(mechanism, state);
      add_magnitude_bounds(mechanism, state, system);
      rows = analyse_rows(system);
    } else {
      rows = structured_row_analysis(model);
    }
    out.rank = rows.rank;
    out.degrees_of_freedom = 6 * mechanism.nb() - rows.rank;
  } else {
    rows.unique.assign(mechanism.nc(), true);
  }
  if (is_dense) out.condition = rows.kappa;
  out.mu = plain(rows.mu);
  for (int k = 0; k < mechanism.nc(); ++k)
    out.rows.push_back({consistency.positions[k].residual, consistency.velocities[k].residual,
                        consistency.positions[k].size, consistency.velocities[k].size, rows.unique[k],
                        std::binary_search(rows.dependent.begin(), rows.dependent.end(), k)});
  for (const int k : rows.contradictory) out.contradictory.push_back(mechanism.row_names[k]);
  out.warnings = narrow_row_warnings(mechanism.row_names, rows);
  out.wrong_branches = consistency.wrong_branches;
  for (const scenes::Body& body : scene.bodies)
    if (body.unphysical_inertia) out.unphysical_inertia.push_back(body.name);
  out.is_consistent = consistency.holds();
  out.inconsistency = consistency.report();
  add_energy(model, out);
  return out;
}

}  // namespace trivium
