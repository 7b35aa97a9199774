#pragma once
/// Regular scenes of any size, consistent by construction: chains, ladders, trees, rings and hubs. Cost is
/// measured on them.

#include <cstdint>

#include "scenes/scene.hpp"

namespace trivium::scenes {

/// n bars (1 kg, 1 m, 0.1 m square) in series on revolutes whose axes alternate between y and z, bent and
/// turning, under gravity along -z. Throws std::invalid_argument for n < 1, as the others do.
Scene chain(int n);

/// Two of these bars at 0.3 and 0.5 rad, turning at 0.1 and -0.2 rad/s: a double pendulum in space.
Scene two_bars();

/// The N-four-bar ladder of IFToMM benchmark A02: 2 n + 1 slender rods without axial inertia, 3 n + 1
/// revolutes about z, upright, the top moving at 1 m/s; the catalogue's n_four_bar_* with n loops.
Scene ladder(int n);

/// n bars, each hung on a bar drawn among those before it by a revolute with an axis of its own, turning; the
/// same tree for the same seed.
Scene tree(int n, std::uint64_t seed = 1);

/// A closed ring: a regular polygon of n >= 3 bars, upright in the x-z plane, on spherical joints; the first
/// bar turns about its centre on a revolute along y and all others spin and leave the plane. 3 n + 5 rows,
/// none redundant.
Scene ring(int n);

/// A wheel (10 kg, 1 m, upright axle) and n bars on revolutes around its rim, all turning: one body with
/// n + 1 joints.
Scene hub(int n);

}  // namespace trivium::scenes
