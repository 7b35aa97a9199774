#pragma once
/// A scene in MuJoCo's language, MJCF: bodies nested by joints, and what closes loops as equality
/// constraints. MuJoCo reads it as text, so numbers have all their digits.

#include <string>
#include <vector>

#include "validation/cost/peer_scene.hpp"

namespace trivium::cost {

struct TextFile {
  std::string name, text;
};

/// MJCF whose reference pose is the scene's: all joint coordinates are zero there. Bodies `b<index>`, joints
/// in the order of the tree, depth first. The first file is the model; what nests deeper than MuJoCo's parser
/// goes is in files that it includes. Throws NotTaken.
std::vector<TextFile> mujoco_files(const PeerScene& scene);

/// The velocities of all joints in the order of that text.
std::vector<double> mujoco_velocities(const PeerScene& scene);

}  // namespace trivium::cost
