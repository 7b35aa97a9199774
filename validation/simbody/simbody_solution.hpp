#pragma once
/// Simbody's answer in our terms: accelerations, lambda of all rows and joint reactions. Signs and factors
/// stand in multiplier_signs.hpp.

#include <vector>

#include "validation/simbody/reaction_frame.hpp"
#include "validation/simbody/solve.hpp"

namespace trivium {

struct SimbodySolution {
  PhysicalSolution<double> solution;
  std::vector<JointReaction> reactions;
};

/// Where a joint became a mobilizer its lambda is the one that its reaction stands for.
SimbodySolution to_trivium_solution(const simbody::Model& model, const simbody::Answer& answer,
                                    const ReactionFrame& frame);

}  // namespace trivium
