#pragma once
/// The reference solution for all engines: r-omega in quad. The file also defines the errors of an engine's
/// accelerations and multipliers relative to this solution.

#include <vector>

#include "scenes/scene.hpp"
#include "validation/cost/engine.hpp"

namespace trivium::cost {

/// The solution, rounded to double.
struct QuadSolution {
  std::vector<Vector3> r_ddot;
  std::vector<double> lambda;
  std::vector<bool> unique;  ///< per row: whether the multiplier is unique

  /// The largest difference of a body's r'', relative to the largest r'' [-].
  double error_of(const std::vector<Vector3>& other) const;
  /// The norm of the difference of lambda relative to the norm of lambda, both over the unique rows [-].
  double lambda_error_of(const std::vector<double>& other) const;
};

/// Solves the scene with the structured solver, or with the printed system if the structured solver cannot.
/// Throws ModelError.
QuadSolution quad_solution(const scenes::Scene& scene);

}  // namespace trivium::cost
