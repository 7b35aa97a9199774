#pragma once
/// Sign and factor between a Simbody multiplier and Trivium's lambda. Internal to the Simbody library.
///
/// Simbody solves M u' + G^T lambda = f, with G the Jacobian of its constraint error. Where this error is Phi
/// itself, Simbody's multiplier lambda_S is equal to lambda. Sign and factor of every mapping:
///
/// - Constraint::Custom, error Phi: DP1, turning DP1, DP2, D and CD with f(t). lambda = lambda_S.
/// - Ball, error p_j - p_i in Ground: CD(e_x), CD(e_y), CD(e_z). lambda = lambda_S.
/// - ConstantAngle, error a_i/|a_i| . a_j/|a_j| - cos(angle): DP1. lambda = lambda_S / (|a_i| |a_j|).
/// - PointInPlane, error a_i/|a_i| . p_j - height: DP2, or CD with i on Ground. lambda = lambda_S / |a_i|.
/// - Rod, error |d| - L; with d . d - L^2 = (|d| - L) (|d| + L): D. lambda = lambda_S / (2 L).
/// - ConstantOrientation, errors y_i . x_j, z_i . y_j, x_i . z_j with (x, y, z) = (u, v, z):
///   lambda(u_i, z_j) = lambda_S[2] and, because on the manifold v_i . u_j varies as -(u_i . v_j) and z_i .
///   v_j as -(v_i . z_j), lambda(u_i, v_j) = -lambda_S[0] and lambda(v_i, z_j) = -lambda_S[1].
/// - Weld: ConstantOrientation's rows, then Ball's.
///
/// Ball and PointInPlane act on the material point of body i that coincides with the point of body j. Their
/// multiplier is therefore equal to lambda only where the constraints are satisfied. The same holds for Rod
/// and ConstantOrientation.
///
/// `calcConstraintForcesFromMultipliers` returns +G^T lambda; the reaction is its negative.
/// `calcMobilizerReactionForces` returns the force on the child at the mobilizer frame M, in Ground
/// components.

#include <Simbody.h>

#include <vector>

namespace trivium::simbody {

/// One row and its factor: lambda[row] = scale * (a multiplier of a Simbody constraint).
struct RowLink {
  int row;
  double scale;
};

/// A Simbody constraint, the joint to which it belongs, and the rows to which its multipliers correspond.
struct LinkedConstraint {
  SimTK::ConstraintIndex index;
  int joint;
  std::vector<RowLink> rows;
};

}  // namespace trivium::simbody
