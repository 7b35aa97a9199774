#pragma once
/// The solution that all engines are measured against: r-omega in quad. Here too is the distance of an
/// engine's accelerations and multipliers from it.

#include <vector>

#include "scenes/scene.hpp"
#include "validation/cost/engine.hpp"

namespace trivium::cost {

/// Rounded to double.
struct QuadSolution {
  std::vector<Vector3> r_ddot;
  std::vector<double> lambda;
  std::vector<bool> unique;  ///< per row: its multiplier is determined

  /// The largest difference over the bodies, relative to the largest acceleration.
  double error_of(const std::vector<Vector3>& other) const;
  /// The norm of the difference relative to that of lambda, both over the unique rows.
  double lambda_error_of(const std::vector<double>& other) const;
};

/// By the structured solver, or as printed where that cannot. Throws ModelError.
QuadSolution quad_solution(const scenes::Scene& scene);

}  // namespace trivium::cost
