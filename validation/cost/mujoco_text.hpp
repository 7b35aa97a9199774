#pragma once
/// Writes a scene in MuJoCo's language MJCF: bodies nested by the joints of the tree, and equality
/// constraints for the closing joints. MuJoCo reads the model as text, so numbers are written with all
/// digits.

#include <string>
#include <vector>

#include "validation/cost/peer_scene.hpp"

namespace trivium::cost {

struct TextFile {
  std::string name, text;
};

/// The MJCF of a scene. Its reference pose is the scene's state, so that all joint coordinates are zero
/// there. Bodies are called `b<index>`; joints are in depth-first order. The first file is the model; it
/// includes the other files, which hold bodies that nest too deeply for MuJoCo's parser. Throws NotTaken.
std::vector<TextFile> mujoco_files(const PeerScene& scene);

/// The velocities of all joints, in the order of that text.
std::vector<double> mujoco_velocities(const PeerScene& scene);

}  // namespace trivium::cost
