#pragma once
/// The report of `trivium compare --against FILE`, which compares a motion of another code with the library's
/// motion, as text, JSON and CSV. simulation/motion_against.hpp decides the bounds.

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
