#pragma once
/// Scenes of the catalogue by name, from the source tree. For tests only.

#include <fmt/format.h>

#include <string_view>

#include "scenes/format/scene_file.hpp"

namespace trivium::test {

inline scenes::Scene catalogue_scene(std::string_view name) {
  return scenes::read_scene_file(fmt::format("{}/{}.json", TRIVIUM_SCENES_DIR, name));
}

}  // namespace trivium::test
