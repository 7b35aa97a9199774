#pragma once
/// The structured solver as an engine, in the formulation of a name. One engine solves a scene again and
/// again.

#include <memory>
#include <string>
#include <vector>

#include "scenes/scene.hpp"
#include "validation/cost/engine.hpp"

namespace trivium::cost {

enum class Refined { no, yes };

/// Throws a ModelError, also where there is no such formulation.
std::unique_ptr<Engine> trivium_engine(const scenes::Scene& scene, const std::string& formulation,
                                       Refined refined);

/// Per row: its multiplier is determined. Throws ModelError.
std::vector<bool> unique_multipliers(const scenes::Scene& scene);

}  // namespace trivium::cost
