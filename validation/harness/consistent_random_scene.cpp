/// Tries random mechanisms until one has velocities and accelerations that satisfy its constraints.

#include "validation/harness/consistent_random_scene.hpp"

#include <fmt/format.h>

#include "formulations/analysis/assemble.hpp"
#include "formulations/analysis/consistency.hpp"
#include "formulations/analysis/row_analysis.hpp"
#include "formulations/analysis/tangent_system.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/scene_state.hpp"

namespace trivium {

NamedScene consistent_random_scene(std::uint64_t seed, const scenes::RandomOptions& options) {
  // The functions of time of a locked loop may contradict each other. Then no consistent velocity or
  // acceleration exists, and the mechanism of the next attempt is taken. 2^40 is above all usual seeds, so
  // that a second attempt is not the first one of another seed.
  for (std::uint64_t attempt = 0;; ++attempt) {
    scenes::RandomScene random = scenes::random_scene(seed + (attempt << 40), options);
    random.scene.name = fmt::format("random_{}", seed);
    auto [mechanism, state] = make_model<double>(random.scene, random.t);
    project_velocities(mechanism, state);
    set_state(random.scene, state);
    state = make_state<double>(random.scene, random.t);  // as a file would have it
    if (check_consistency(mechanism, state).holds() &&
        analyse_rows(tangent_system(mechanism, state)).contradictory.empty())
      return {fmt::format("random mechanism of seed {}", seed), std::move(random.scene),
              Model<double>{std::move(mechanism), std::move(state)}};
  }
}

}  // namespace trivium
