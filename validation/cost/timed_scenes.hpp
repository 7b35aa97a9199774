#pragma once
/// The scenes that engines are timed on: members of a family of any size, made by their names, and scenes of
/// the catalogue or of files. Decides which are timed where none is named.

#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace trivium::cost {

struct TimedScene {
  std::string name;    ///< chain_100, stewart_platform ...
  std::string family;  ///< chain, ladder ...; the name where there is no n
  int n = 0;           ///< bars or loops; 0: not one of a family
  scenes::Scene scene;
};

/// By name: a kind of `trivium generate` and a number (chain_100), else a scene of the catalogue or a file.
/// Throws InputErrors about all that fail.
std::vector<TimedScene> timed_scenes(const std::vector<std::string>& names);

/// What is timed where no scene is named.
std::vector<std::string> default_scene_names(bool quick);

}  // namespace trivium::cost
