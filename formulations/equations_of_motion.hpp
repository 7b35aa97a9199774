#pragma once
/// The equations of motion of a mechanism in one formulation at one state, as separate terms of every body
/// and row; no matrix is assembled. The printed and the structured solver both start from these terms.

#include <vector>

#include "constraints/constraint_row.hpp"
#include "formulations/body_state.hpp"

namespace trivium {

/// The terms of the equations of motion at one state; nb bodies and nc rows.
template <EquationsAsPrinted F>
struct EquationsOfMotion {
  using S = typename F::Scalar;
  using Row = ConstraintRow<S, F::rotational_unknowns>;
  using Acceleration = BodyAcceleration<S, F::rotational_unknowns>;

  S t{0};                                    ///< time [s]
  std::vector<typename F::Kinematics> body;  ///< kinematics; nb + 1 entries, the last is the ground
  std::vector<S> mass;                       ///< [kg]
  /// Inertia in the rotational unknowns, n x n per body (EquationsAsPrinted).
  std::vector<Matrix<S, F::rotational_unknowns, F::rotational_unknowns>> mass_block;
  std::vector<Vector3<S>> F_applied;  ///< applied forces F [N, global]
  /// Right side of the rotational equations: applied_force + velocity_force [N m] of the formulation.
  std::vector<typename F::Unknown> tau;
  std::vector<BodyPair> pair;  ///< the bodies of each row
  std::vector<Row> row;        ///< Phi, nu, gamma and the Jacobian blocks of each row

  int nb() const { return static_cast<int>(mass.size()); }
  int nc() const { return static_cast<int>(row.size()); }
};

/// The terms at the state `bodies` (to_coordinates) and time t [s]. Throws a ModelError if an effect is not
/// defined at this state.
template <EquationsAsPrinted F, class Types>
EquationsOfMotion<F> equations_of_motion(const Mechanism<typename F::Scalar, Types>& mechanism,
                                         const std::vector<BodyState<F>>& bodies,
                                         const typename F::Scalar& t);

}  // namespace trivium
