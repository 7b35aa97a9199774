#pragma once
/// Turns a JSON document into a scene. The result has valid keys, types, array lengths and names; whether its
/// numbers make sense is checked by scene_checks.hpp.

#include "scenes/format/json.hpp"
#include "scenes/scene.hpp"

namespace trivium::scenes {

/// The scene of a document. Throws a SceneError.
Scene read_scene(const Json& json, const Path& root);

}  // namespace trivium::scenes
