#pragma once
/// Solves a model at its state with Simbody: accelerations, multipliers and joint reactions. The multipliers
/// have the sign and scale of Trivium's lambda (multiplier_signs.hpp). Plain C++17, like model.hpp.

#include <vector>

#include "validation/simbody/way.hpp"

namespace trivium::simbody {

/// Force [N], and torque [N m] about `point`, the joint's point on body i; Ground components.
struct Reaction {
  Vector3 force{}, torque{}, point{};
};

struct Answer {
  std::vector<Vector3> r_ddot;         ///< of the centres of mass [m/s^2], global frame
  std::vector<Vector3> omega_bar_dot;  ///< [rad/s^2], body frame
  std::vector<double> lambda;          ///< one for each row; 0 if `lambda_known` is false
  std::vector<bool> lambda_known;      ///< false for the rows of a joint that became a mobilizer
  /// The reactions of each joint on its bodies. They are opposite, except for a CD with distant points: its
  /// force acts at both points along its own direction, not along the line between them.
  std::vector<Reaction> reactions_on_i, reactions_on_j;
  double pose_defect = 0;      ///< largest difference of a pose or velocity from the model's state
  double jacobian_defect = 0;  ///< largest entry of G (from errors) - G (from forces)
  int mobilizers = 0;          ///< joints that became mobilizers
  int idle_rows = 0;           ///< closing rows that the tree satisfies identically; disabled, lambda = 0
  int constraint_rows = 0;     ///< number of rows that became constraints
};

/// Solves the model; all numbers of the result are finite. Throws Refused, and no other exception.
Answer solve(const Model& model, Way way);

}  // namespace trivium::simbody
