#pragma once
/// From a JSON document to a scene. Words, types, lengths and names are right afterwards; whether the numbers
/// make sense is for scene_checks.hpp.

#include "scenes/format/json.hpp"
#include "scenes/scene.hpp"

namespace trivium::scenes {

Scene read_scene(const Json& json, const Path& root);

}  // namespace trivium::scenes
