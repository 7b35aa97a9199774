#pragma once
/// The structured solver as an engine, and the solution in quad that all engines are measured against.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "scenes/scene.hpp"
#include "validation/cost/engine.hpp"

namespace trivium::cost {

enum class Refined { no, yes };

inline constexpr std::array formulations{"r-omega", "r-p", "r-epsilon"};

/// Throws ModelError.
std::unique_ptr<Engine> our_engine(const scenes::Scene& scene, const std::string& formulation,
                                   Refined refined);

/// Per row: its multiplier is determined. Throws ModelError.
std::vector<bool> unique_multipliers(const scenes::Scene& scene);

/// r-omega in quad, rounded to double.
struct Exact {
  std::vector<Vector3> r_ddot;
  std::vector<double> lambda;
  std::vector<bool> unique;  ///< per row: its multiplier is determined

  /// The largest difference over the bodies, relative to the largest acceleration.
  double error_of(const std::vector<Vector3>& other) const;
  /// The norm of the difference relative to that of lambda, both over the unique rows.
  double lambda_error_of(const std::vector<double>& other) const;
};

/// By the structured solver, or as printed where that cannot. Throws ModelError.
Exact exact_solution(const scenes::Scene& scene);

}  // namespace trivium::cost
