#pragma once
/// Engines of other projects, if they were installed when the program was built. Each function throws
/// NotTaken if the engine does not accept the scene, and std::runtime_error if the engine fails on it.

#include <memory>
#include <string>
#include <vector>

#include "validation/cost/peer_scene.hpp"

namespace trivium::cost {

struct Peer {
  std::string name;
  std::unique_ptr<Engine> (*make)(const PeerScene&);
};

/// The engines that are available.
std::vector<Peer> peers();
/// The packages of the engines that are not available.
std::vector<std::string> missing_peers();

/// Simbody: a tree of mobilizers, realised to Stage::Acceleration. Closing joints become Simbody's own
/// constraints. Those of one row are disabled if the tree satisfies them identically.
std::unique_ptr<Engine> simbody_engine(const PeerScene& scene);
/// MuJoCo: mj_forward, with contacts and other unneeded features switched off. Closing joints become
/// `connect` equalities, which are soft, with the highest stiffness possible. MuJoCo omits the
/// velocity-dependent terms of their accelerations: the error is of the size of these terms if the scene
/// moves (ring_12: 0.2 moving, 8e-6 at rest).
std::unique_ptr<Engine> mujoco_engine(const PeerScene& scene);
/// DART: Skeleton::computeForwardDynamics; trees only.
std::unique_ptr<Engine> dart_engine(const PeerScene& scene);

}  // namespace trivium::cost
