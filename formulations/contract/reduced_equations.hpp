#pragma once
/// The second part of a formulation: the equations of one body with the internal row eliminated in closed
/// form, so that three rotational unknowns x remain. The structured solver needs nothing else.
///
///     q'' = from_reduced(x),    reduced_mass_block x + Phi_x^T lambda = reduced_force(n_bar)

#include <concepts>

#include "constraints/body_kinematics.hpp"
#include "formulations/contract/angular_motion.hpp"

namespace trivium {

/// What a formulation F must have for the structured solver, in addition to the printed equations. F::Reduced
/// is the kinematics of a body in the unknowns x: F::Kinematics itself, or a type that is derived from it and
/// is made by Reduced{kinematics}. Functions with a parameter Kinematics are also called with a Reduced.
template <class F>
concept ReducedEquations = BodyKinematics<typename F::Reduced> && F::Reduced::rotational_unknowns == 3 &&
                           requires(const Vector3<typename F::Scalar>& v,
                                    const Matrix3<typename F::Scalar>& J_bar,
                                    const typename F::Kinematics& body, const typename F::Reduced& reduced,
                                    const typename F::Unknown& force) {
  // A and omega at the state, and omega' as a linear function of x
  { F::angular_motion(reduced) } -> std::same_as<AngularMotion<typename F::Scalar>>;
  // whether reduced_mass_block is independent of the state
  { F::reduced_mass_is_constant } -> std::convertible_to<bool>;
  { F::reduced_mass_block(body, J_bar) } -> std::convertible_to<Matrix3<typename F::Scalar>>;
  { F::reduced_force(body, J_bar, v) } -> std::convertible_to<Vector3<typename F::Scalar>>;
  { F::from_reduced(body, v) } -> std::convertible_to<typename F::Unknown>;
  // omega_bar' from x
  { F::omega_bar_dot_from_reduced(body, v) } -> std::convertible_to<Vector3<typename F::Scalar>>;
  // the linear part of from_reduced: the change of q'' with x
  { F::increment(body, v) } -> std::convertible_to<typename F::Unknown>;
  // a generalized force reduced to x, without its part along the internal row; and a reduced force as a
  // moment [N m, body frame]
  { F::reduced(reduced, force) } -> std::convertible_to<Vector3<typename F::Scalar>>;
  { F::moment(reduced, v) } -> std::convertible_to<Vector3<typename F::Scalar>>;
};

}  // namespace trivium
