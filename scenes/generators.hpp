#pragma once
/// Generates regular scenes of any size: chains, ladders, trees, rings and hubs. Their positions and
/// velocities satisfy the constraints by construction. The measurements of computing time use these scenes.

#include <cstdint>

#include "scenes/scene.hpp"

namespace trivium::scenes {

/// n bars (1 kg, 1 m long, 0.1 m square) in series on revolutes whose axes alternate between y and z. The
/// chain is bent and in motion, under gravity along -z. Like the other generators it throws
/// std::invalid_argument if n is too small (here n < 1).
Scene chain(int n);

/// A double pendulum in space: two bars as in chain(), at 0.3 and 0.5 rad, turning at 0.1 and -0.2 rad/s.
Scene two_bars();

/// The N-four-bar ladder of IFToMM benchmark A02 with n loops, as in n_four_bar_* of the catalogue: 2 n + 1
/// slender rods without axial moment of inertia, 3 n + 1 revolutes about z, upright, the top moving at 1 m/s.
Scene ladder(int n);

/// A tree of n moving bars. Each bar hangs on a randomly drawn earlier bar by a revolute with a random axis.
/// The same seed gives the same tree.
Scene tree(int n, std::uint64_t seed = 1);

/// A closed ring: a regular polygon of n >= 3 bars on spherical joints, upright in the x-z plane. The
/// midpoint of the first bar is the origin, about which it turns on a revolute along y. All other bars also
/// spin and leave the plane. The ring has 3 n + 5 rows, none redundant.
Scene ring(int n);

/// A wheel (10 kg, radius 1 m, upright axle) with n bars on revolutes around its rim, all turning: a scene
/// with one body that has n + 1 joints.
Scene hub(int n);

}  // namespace trivium::scenes
