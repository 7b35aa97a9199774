#pragma once
/// From a scene to what other engines are told of it: a tree of joints, and what closes its loops. Decided
/// here: which scenes no peer can take, and what is raised for engines that refuse moments of zero.

#include "scenes/scene.hpp"
#include "validation/cost/peer_scene.hpp"

namespace trivium::cost {

/// The scene at its state, at time 0. Principal moments of inertia below 1e-6 of the body's largest are
/// raised to that, because MuJoCo and DART refuse zero; a slender rod that cannot turn about itself does not
/// feel it.
PeerScene to_peers(const scenes::Scene& scene);

}  // namespace trivium::cost
