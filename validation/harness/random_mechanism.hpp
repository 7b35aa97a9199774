#pragma once
/// Random mechanisms with consistent states at a random time: trees and closed loops, every joint and basic
/// constraint, drivers, springs, mass ratios to 1e6. Bodies are placed first and joints fitted to them, so
/// positions hold by construction in any graph; velocities are projected.

#include <cstdint>

#include "scenes/scene.hpp"

namespace trivium {

struct RandomMechanism {
  scenes::Scene scene;
  double t = 0;  ///< the time at which its state holds
};

struct RandomOptions {
  int most_bodies = 8;
  double mass_ratio = 1e6;
  bool effects = true;
  bool redundant = true;  ///< now and then a joint that repeats what another does
};

/// The mechanism of a seed; the same for ever.
RandomMechanism random_mechanism(std::uint64_t seed, const RandomOptions& options = {});

}  // namespace trivium
