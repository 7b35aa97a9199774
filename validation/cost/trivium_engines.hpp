#pragma once
/// Trivium's structured solver with the interface of an engine, selected by the name of a formulation. One
/// engine solves the same scene repeatedly.

#include <memory>
#include <string>
#include <vector>

#include "scenes/scene.hpp"
#include "validation/cost/engine.hpp"

namespace trivium::cost {

enum class Refined { no, yes };

/// The engine of a formulation in double. Throws a ModelError, also if there is no formulation with this
/// name.
std::unique_ptr<Engine> trivium_engine(const scenes::Scene& scene, const std::string& formulation,
                                       Refined refined);

/// Per row, whether the multiplier is unique. Throws ModelError.
std::vector<bool> unique_multipliers(const scenes::Scene& scene);

}  // namespace trivium::cost
