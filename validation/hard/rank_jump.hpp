#pragma once
/// The misalignment at which a second hinge locks a door. Around the rank tolerance the rank must jump once,
/// at the same angle for all.

#include "scenes/scene.hpp"
#include "validation/hard/judge.hpp"

namespace trivium::hard {

/// A door at rest on two hinges whose axes differ by `angle` [rad].
scenes::Scene misaligned_door(double angle);

/// How often the rank jumps between 1e-14 and 1e-4 rad, and whether it does so at the same angle in all
/// formulations and both solvers.
void judge_rank_jump(Judge& judge, double angles_per_decade);

}  // namespace trivium::hard
