#pragma once
/// Random scenes, consistent by construction: poses first, joint geometry fitted to them, velocities
/// projected onto the constraints. A support of the tests.

#include <cstdint>
#include <vector>

#include "scenes/scene.hpp"

namespace trivium::test {

struct MechanismOptions {
  int bodies = 3;
  int closings = 1;            ///< rows beyond the spanning tree, so that there are loops
  int doubled = 0;             ///< joints given a second time at another point: redundant rows
  bool driven = false;         ///< a rotation driver beside the first revolute, f(t) in the closing rows
  double mass_decades = 0.5;   ///< masses spread over this many powers of ten, up and down
  double gimbal_distance = 0;  ///< sin(theta) of every body in 3-1-3; 0 for orientations anywhere
  double near_rows = 0;        ///< a closing row and one more that differs from it by this much; 0 for none
};

/// The state is that at t = 0.
scenes::Scene random_scene(std::uint64_t seed, const MechanismOptions& options = {});

/// The velocities nearest in the mass metric to the given ones that satisfy Phi_q q' = nu at t = 0.
void project_velocities(scenes::Scene& scene);

}  // namespace trivium::test
