#pragma once
/// Arbitrary scenes for property tests: every key of the format in any allowed form, sensible as a mechanism
/// or not. A support of the tests.

#include "scenes/scene.hpp"

namespace trivium::scenes {

/// To be called within a rapidcheck property, whose choices it draws on and which can thus shrink it. A scene
/// that every reader must accept: up to a dozen bodies, constraints and effects of all types, numbers from
/// 1e-20 to 1e20.
Scene arbitrary_scene();

}  // namespace trivium::scenes
