#pragma once
/// What stands behind a Scene of the front door: the scene as the library has it. The library's own sources
/// include this; its users see trivium/scene.hpp.

#include <string>

#include "scenes/scene.hpp"
#include "trivium/scene.hpp"

namespace trivium {

struct Scene::Contents {
  scenes::Scene scene;
  double t = 0;        ///< of its state [s]
  std::string source;  ///< as messages name it: a file, or the name of what was built
};

}  // namespace trivium
