#pragma once
/// The engine MuJoCo at one state, or at many states of the same scene. The model is read from text
/// (mujoco_text.hpp) before any timing.

#include <span>

#include "scenes/make_mechanism.hpp"
#include "validation/cost/peers.hpp"

namespace trivium::cost {

inline constexpr const char* mujoco_name = "MuJoCo 2.2.2";

class MujocoEngine : public Engine {
 public:
  virtual void set_state(std::span<const double> qpos, std::span<const double> qvel) = 0;
};

/// Throws as mujoco_engine does (peers.hpp).
std::unique_ptr<MujocoEngine> mujoco_engine_with_states(const PeerScene& scene);

}  // namespace trivium::cost
