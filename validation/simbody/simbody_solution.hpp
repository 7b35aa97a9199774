#pragma once
/// Converts Simbody's answer to Trivium's quantities: accelerations, lambda of all rows and joint reactions.
/// Signs and factors are documented in multiplier_signs.hpp.

#include <vector>

#include "validation/simbody/reaction_frame.hpp"
#include "validation/simbody/solve.hpp"

namespace trivium {

struct SimbodySolution {
  PhysicalSolution<double> solution;
  std::vector<JointReaction> reactions;
};

/// Converts the answer. If a joint became a mobilizer, its lambda is computed from its reaction.
SimbodySolution to_trivium_solution(const simbody::Model& model, const simbody::Answer& answer,
                                    const ReactionFrame& frame);

}  // namespace trivium
