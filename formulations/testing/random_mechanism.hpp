#pragma once
/// Random scenes that are consistent by construction: random poses, joint geometry fitted to the poses, and
/// velocities projected onto the constraints. Support for tests.

#include <cstdint>
#include <vector>

#include "scenes/scene.hpp"

namespace trivium::test {

struct MechanismOptions {
  int bodies = 3;
  int closings = 1;            ///< rows in addition to the spanning tree: loops
  int doubled = 0;             ///< repeated joints: redundant rows
  bool driven = false;         ///< a rotation driver on the first revolute, f(t) in the closing rows
  double mass_decades = 0.5;   ///< masses between 10^-this and 10^this
  double gimbal_distance = 0;  ///< angle theta of every body in 3-1-3 [rad]; 0: random orientations
  double near_rows = 0;  ///< distance [m] of the points of two nearly equal closing rows; 0: no such rows
};

/// The scene of a seed, with its state at t = 0.
scenes::Scene random_scene(std::uint64_t seed, const MechanismOptions& options = {});

/// Replaces the velocities by the nearest ones in the mass metric that satisfy Phi_q q' = nu at t = 0.
void project_velocities(scenes::Scene& scene);

}  // namespace trivium::test
