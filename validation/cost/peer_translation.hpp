#pragma once
/// Translates a scene into the form that other engines get (peer_scene.hpp). This file also decides how
/// moments of inertia are raised for engines that refuse zero.

#include "scenes/scene.hpp"
#include "validation/cost/peer_scene.hpp"

namespace trivium::cost {

/// Translates the scene at its state, at time 0. Principal moments of inertia below 1e-6 of the body's
/// largest moment are raised to this value, because MuJoCo and DART refuse zero. This does not change the
/// motion of a slender rod that cannot turn about its axis.
PeerScene to_peers(const scenes::Scene& scene);

}  // namespace trivium::cost
