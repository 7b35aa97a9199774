#pragma once
/// The scenes on which engines are timed: generated scenes of any size, selected by name, and scenes from the
/// catalogue or from files. This file also decides which scenes are timed if the command line names none.

#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace trivium::cost {

struct TimedScene {
  std::string name;    ///< for example chain_100, stewart_platform
  std::string family;  ///< for example chain, ladder; the name if the scene has no size n
  int n = 0;           ///< number of bars or loops; 0 for scenes that are not generated
  scenes::Scene scene;
};

/// The scenes of these names: a kind of `trivium generate` with a number (chain_100), or a scene of the
/// catalogue, or a file. Throws InputErrors with a message for each scene that cannot be loaded.
std::vector<TimedScene> timed_scenes(const std::vector<std::string>& names);

/// The scenes that are timed if the command line names none.
std::vector<std::string> default_scene_names(bool quick);

}  // namespace trivium::cost
