#pragma once
/// What `trivium compare --against FILE` says of a motion of another code beside the library's, as text, JSON
/// and CSV. Which bounds there are is simulation/motion_against.hpp's to decide.

#include <string>

#include "simulation/motion_against.hpp"

namespace trivium {

struct AgainstReport {
  const std::string& scene;
  const std::string& file;
  const OtherMotion& other;
  const SimulationOptions& options;
  const MotionAgainst& comparison;

  std::string text() const;
  std::string json() const;
  std::string csv() const;
};

}  // namespace trivium
