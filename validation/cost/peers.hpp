#pragma once
/// The engines of others, as far as they were installed when this was built. Each function throws NotTaken
/// for what its engine does not take, and std::runtime_error for what it cannot do.

#include <memory>
#include <string>
#include <vector>

#include "validation/cost/peer_scene.hpp"

namespace trivium::cost {

struct Peer {
  std::string name;
  std::unique_ptr<Engine> (*make)(const PeerScene&);
};

/// Those that are there.
std::vector<Peer> peers();
/// The packages of those that are not.
std::vector<std::string> missing_peers();

/// A tree of mobilizers, realised to Stage::Acceleration; closing joints by Simbody's own constraints, those
/// that the tree satisfies by itself disabled.
std::unique_ptr<Engine> simbody_engine(const PeerScene& scene);
/// mj_forward, contacts and all that costs and is not asked for switched off; closing joints by soft
/// `connect` equalities, as stiff as they go. Of a closing's acceleration MuJoCo leaves out what stems from
/// velocities: an error of the size of those terms where the scene moves (ring_12: 0.2 moving, 8e-6 at rest).
std::unique_ptr<Engine> mujoco_engine(const PeerScene& scene);
/// Skeleton::computeForwardDynamics, of trees.
std::unique_ptr<Engine> dart_engine(const PeerScene& scene);

}  // namespace trivium::cost
