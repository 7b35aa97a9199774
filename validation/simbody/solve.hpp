#pragma once
/// Accelerations, multipliers and joint reactions of a model at its state, as Simbody computes them; the
/// multipliers with the sign and scale of ours (multiplier_signs.hpp). Plain C++17, like model.hpp.

#include <vector>

#include "validation/simbody/way.hpp"

namespace trivium::simbody {

/// Force, and torque about `point` (the joint's point on body i), Ground components.
struct Reaction {
  Vector3 force{}, torque{}, point{};
};

struct Answer {
  std::vector<Vector3> r_ddot;         ///< of the centres of mass, global
  std::vector<Vector3> omega_bar_dot;  ///< body frame
  std::vector<double> lambda;          ///< one per row; 0 where `lambda_known` is false
  std::vector<bool> lambda_known;      ///< false in the rows of a joint that became a mobilizer
  /// Per joint, on either body. They are opposite but for a CD whose points are apart: it acts along its own
  /// direction at both points, not along the line between them.
  std::vector<Reaction> reactions_on_i, reactions_on_j;
  double pose_defect = 0;      ///< the largest difference of a pose or velocity from the model's state
  double jacobian_defect = 0;  ///< the largest entry of G (from errors) - G (from forces)
  int mobilizers = 0;          ///< joints that became mobilizers
  int idle_rows = 0;           ///< closing rows that the tree satisfies identically: disabled, lambda 0
  int constraint_rows = 0;     ///< rows that became constraints
};

/// Throws Refused, and nothing else; what it returns is finite.
Answer solve(const Model& model, Way way);

}  // namespace trivium::simbody
