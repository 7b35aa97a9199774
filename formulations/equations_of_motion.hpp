#pragma once
/// The equations of motion of a mechanism in one formulation, at one state: body by body and row by row,
/// nothing assembled. The printed and the structured solver both start here.

#include <vector>

#include "constraints/constraint_row.hpp"
#include "formulations/body_state.hpp"

namespace trivium {

/// All pieces of the equations of motion at one state.
template <EquationsAsPrinted F>
struct EquationsOfMotion {
  using S = typename F::Scalar;
  using Row = ConstraintRow<S, F::rotational_unknowns>;
  using Acceleration = BodyAcceleration<S, F::rotational_unknowns>;

  S t{0};
  std::vector<typename F::Kinematics> body;  ///< nb + 1, the ground last
  std::vector<S> mass;
  std::vector<Matrix<S, F::rotational_unknowns, F::rotational_unknowns>> mass_block;
  std::vector<Vector3<S>> F_applied;     ///< F
  std::vector<typename F::Unknown> tau;  ///< applied + velocity force of the rotational equations
  std::vector<BodyPair> pair;
  std::vector<Row> row;

  int nb() const { return static_cast<int>(mass.size()); }
  int nc() const { return static_cast<int>(row.size()); }
};

template <EquationsAsPrinted F, class Types>
EquationsOfMotion<F> equations_of_motion(const Mechanism<typename F::Scalar, Types>& mechanism,
                                         const std::vector<BodyState<F>>& bodies,
                                         const typename F::Scalar& t);

}  // namespace trivium
