#pragma once
/// Generates random scenes: trees and closed loops with joints and basic constraints of every type, drivers,
/// springs, and mass ratios up to 1e6. Bodies are placed first and joints are fitted to them, so that
/// positions satisfy the constraints in any graph. Velocities are drawn freely and violate the constraints;
/// validation programs make them consistent first (validation/harness/consistent_random_scene.hpp).

#include <cstdint>

#include "scenes/scene.hpp"

namespace trivium::scenes {

/// A random scene and the time to which its positions belong.
struct RandomScene {
  Scene scene;
  double t = 0;  ///< time at which the positions satisfy the constraints [s]
};

/// Limits of a random scene.
struct RandomOptions {
  int most_bodies = 8;      ///< largest number of bodies, without the ground
  double mass_ratio = 1e6;  ///< largest ratio of two masses [-]
  bool effects = true;      ///< also add effects
  bool redundant = true;    ///< also add, at random, joints that repeat an existing joint
};

/// The random scene of a seed. A seed gives the same scene on every platform, and in every version until a
/// type of constraint is added.
RandomScene random_scene(std::uint64_t seed, const RandomOptions& options = {});

}  // namespace trivium::scenes
