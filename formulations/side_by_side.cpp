#include "formulations/side_by_side.hpp"

#include "formulations/analysis/magnitude_bounds.hpp"
#include "formulations/r_epsilon_omega_first.hpp"
#include "formulations/r_p.hpp"

namespace trivium {

namespace {

template <Formulation F>
Sparsity sparsity_of(const Mechanism<double>& mechanism, const MechanismState<double>& state) {
  const auto eom = equations_of_motion<F>(mechanism, to_coordinates<F>(mechanism, state, {}), state.t);
  const auto filled = [](const auto& block) { return static_cast<long>((block.array() != 0.0).count()); };
  Sparsity s{std::string(F::name)};
  s.size = (3 + F::rotational_unknowns + F::internal_constraints) * eom.nb() + eom.nc();
  for (int b = 0; b < eom.nb(); ++b) {
    s.nonzeros += 3 + filled(eom.mass_block[b]);
    if constexpr (F::internal_constraints > 0) s.nonzeros += 2 * filled(F::internal_jacobian(eom.body[b]));
  }
  for (int k = 0; k < eom.nc(); ++k) {
    const auto& row = eom.row[k];
    if (eom.pair[k].i != eom.nb()) s.nonzeros += 2 * (filled(row.r_i) + filled(row.rot_i));
    if (eom.pair[k].j != eom.nb()) s.nonzeros += 2 * (filled(row.r_j) + filled(row.rot_j));
  }
  return s;
}

}  // namespace

std::vector<Sparsity> augmented_sparsity(const Model<double>& model) {
  const auto& [mechanism, state] = model;
  return {sparsity_of<ROmega<double>>(mechanism, state), sparsity_of<RP<double>>(mechanism, state),
          sparsity_of<REpsilon<double>>(mechanism, state)};
}

std::vector<std::string> formulation_names() {
  return {std::string(ROmega<double>::name), std::string(RP<double>::name),
          std::string(REpsilon<double>::name), std::string(REpsilonOmegaFirst<double>::name)};
}

namespace {

std::string contradiction(const Mechanism<double>& mechanism, const RowAnalysis& rows) {
  std::string names;
  for (int k : rows.contradictory) names += (names.empty() ? "" : ", ") + mechanism.row_names[k];
  return fmt::format(
      "no acceleration satisfies all rows: {} against the rows before; remove a row, or make their "
      "functions of time agree",
      names);
}

}  // namespace

RowAnalysis analyse_rows(const Model<double>& model) {
  const auto& [mechanism, state] = model;
  const int unknowns = 6 * mechanism.nb() + mechanism.nc();
  if (unknowns > most_dense_unknowns)
    throw ModelError(
        fmt::format("{}: {} bodies and {} rows make a dense augmented matrix of {} unknowns, beyond the {} "
                    "that the printed form is "
                    "solved for; take fewer bodies",
                    mechanism.name, mechanism.nb(), mechanism.nc(), unknowns, most_dense_unknowns));
  try {
    TangentSystem system = tangent_system(mechanism, state);
    add_magnitude_bounds(mechanism, state, system);
    RowAnalysis rows = analyse_rows(system);
    if (!rows.contradictory.empty()) throw ModelError(contradiction(mechanism, rows));
    return rows;
  } catch (const ModelError& error) {
    throw ModelError(fmt::format("{} at t = {}: {}", mechanism.name, state.t, error.what()));
  }
}

}  // namespace trivium
