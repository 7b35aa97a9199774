/// Lists the engines of other projects that this build contains, and those that it lacks.

#include "validation/cost/mujoco_engine.hpp"

namespace trivium::cost {

std::vector<Peer> peers() {
  return {
#ifdef TRIVIUM_COST_SIMBODY
      {"Simbody 3.7", simbody_engine},
#endif
#ifdef TRIVIUM_COST_MUJOCO
      {mujoco_name, mujoco_engine},
#endif
#ifdef TRIVIUM_COST_DART
      {"DART 6.12", dart_engine},
#endif
  };
}

std::vector<std::string> missing_peers() {
  return {
#ifndef TRIVIUM_COST_SIMBODY
      "Simbody (libsimbody-dev)",
#endif
#ifndef TRIVIUM_COST_MUJOCO
      "MuJoCo (libmujoco-dev)",
#endif
#ifndef TRIVIUM_COST_DART
      "DART (libdart-dev libdart-external-ikfast-dev)",
#endif
#ifndef TRIVIUM_COST_SUITESPARSE
      "SuiteSparse (libsuitesparse-dev)",
#endif
  };
}

}  // namespace trivium::cost
