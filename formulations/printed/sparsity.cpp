/// Counts the nonzero entries of the blocks of each body and row, twice for blocks that appear transposed.

#include "formulations/printed/sparsity.hpp"

#include "formulations/equations_of_motion.hpp"
#include "formulations/formulation_list.hpp"

namespace trivium {

namespace {

template <EquationsAsPrinted F>
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
  const auto of = [&]<class... F>(const std::tuple<F...>*) {
    return std::vector<Sparsity>{sparsity_of<F>(model.mechanism, model.state)...};
  };
  return of(static_cast<const AllFormulations::In<double>*>(nullptr));
}

}  // namespace trivium
