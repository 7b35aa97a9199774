#pragma once
/// Random scenes: trees and closed loops with every joint and basic constraint, drivers, springs and mass
/// ratios to 1e6. Bodies are placed first and joints fitted to them, so that positions hold by construction
/// in any graph. Velocities are drawn freely and do not hold: validations take
/// consistent ones (validation/harness/consistent_random_scene.hpp).

#include <cstdint>

#include "scenes/scene.hpp"

namespace trivium::scenes {

struct RandomScene {
  Scene scene;
  double t = 0;  ///< the time at which its positions hold
};

struct RandomOptions {
  int most_bodies = 8;
  double mass_ratio = 1e6;
  bool effects = true;
  bool redundant = true;  ///< now and then a joint that repeats what another does
};

/// The scene of a seed; the same everywhere, and for ever unless a basic constraint is added to the list.
RandomScene random_scene(std::uint64_t seed, const RandomOptions& options = {});

}  // namespace trivium::scenes
