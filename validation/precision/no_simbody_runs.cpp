/// Replaces simbody_runs.cpp in a build without Simbody: no settings, and no run.

#include <stdexcept>

#include "validation/precision/runs.hpp"

namespace trivium::precision {

std::vector<RunSettings> peer_settings(bool) { return {}; }
PeerMotion peer_motion(const TimedMotion&, const RunSettings&) {
  throw std::runtime_error("the program was built without Simbody");
}

}  // namespace trivium::precision
