#pragma once
/// Arbitrary scenes for property tests: every key of the format in any allowed form. A scene need not make
/// sense as a mechanism. For tests only.

#include "scenes/scene.hpp"

namespace trivium::scenes {

/// An arbitrary scene that every reader must accept: up to a dozen bodies, constraints and effects of all
/// types, with numbers from 1e-20 to 1e20. Call this function within a rapidcheck property: it draws from the
/// property's choices, so that rapidcheck can shrink the scene.
Scene arbitrary_scene();

}  // namespace trivium::scenes
