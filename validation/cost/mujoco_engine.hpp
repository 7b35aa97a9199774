#pragma once
/// MuJoCo at one state, or at many of the same scene. Its model is read from text (mujoco_text.hpp), before
/// anything is timed.

#include <span>

#include "scenes/make_mechanism.hpp"
#include "validation/cost/peers.hpp"

namespace trivium::cost {

inline constexpr const char* mujoco_name = "MuJoCo 2.2.2";

class MujocoEngine : public Engine {
 public:
  virtual void set_state(std::span<const double> qpos, std::span<const double> qvel) = 0;
};

/// Throws like mujoco_engine.
std::unique_ptr<MujocoEngine> mujoco_engine_with_states(const PeerScene& scene);

}  // namespace trivium::cost
