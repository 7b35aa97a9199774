#pragma once
/// Random mechanisms whose states are consistent, for validations: random scenes (scenes/random_scene.hpp)
/// with their velocities projected. Here it is decided which draws are drawn again: those that contradict
/// themselves.

#include "scenes/random_scene.hpp"
#include "validation/harness/named_scene.hpp"

namespace trivium {

/// The mechanism of a seed; the same for ever.
NamedScene consistent_random_scene(std::uint64_t seed, const scenes::RandomOptions& options = {});

}  // namespace trivium
