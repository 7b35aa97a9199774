#pragma once
/// Random mechanisms with consistent states, for validation programs: random scenes (scenes/random_scene.hpp)
/// with projected velocities. This file decides which random scenes are replaced: those whose constraints
/// contradict each other.

#include "scenes/random_scene.hpp"
#include "validation/harness/named_scene.hpp"

namespace trivium {

/// The random mechanism of a seed. The same seed always gives the same mechanism.
NamedScene consistent_random_scene(std::uint64_t seed, const scenes::RandomOptions& options = {});

}  // namespace trivium
