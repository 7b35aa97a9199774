#pragma once
/// The contents of a public trivium::Scene. Only the library's own sources include this header; users include
/// trivium/scene.hpp.

#include <string>

#include "scenes/scene.hpp"
#include "trivium/scene.hpp"

namespace trivium {

/// The scene in the library's own type.
struct Scene::Contents {
  scenes::Scene scene;
  double t = 0;        ///< time of the state [s]
  std::string source;  ///< name of the scene in error messages: its file, or `scene "name"` if it was built
};

}  // namespace trivium
