#pragma once
/// The second part of a formulation: the internal row eliminated in closed form, so that three rotational
/// unknowns x are left to a body. All that the structured solver asks for.
///
///   q'' = from_reduced(x),    reduced_mass_block x + Phi_x^T lambda = reduced_force(n_bar)

#include <concepts>

#include "constraints/body_kinematics.hpp"
#include "formulations/contract/angular_motion.hpp"

namespace trivium {

template <class F>
concept ReducedEquations = BodyKinematics<typename F::Reduced> && F::Reduced::rotational_unknowns == 3 &&
                           requires(const Vector3<typename F::Scalar>& v,
                                    const Matrix3<typename F::Scalar>& J_bar,
                                    const typename F::Kinematics& body, const typename F::Reduced& reduced,
                                    const typename F::Unknown& force) {
  { F::angular_motion(reduced) } -> std::same_as<AngularMotion<typename F::Scalar>>;
  { F::reduced_mass_is_constant } -> std::convertible_to<bool>;
  { F::reduced_mass_block(body, J_bar) } -> std::convertible_to<Matrix3<typename F::Scalar>>;
  { F::reduced_force(body, J_bar, v) } -> std::convertible_to<Vector3<typename F::Scalar>>;
  { F::from_reduced(body, v) } -> std::convertible_to<typename F::Unknown>;
  // how far the unknown moves with x
  { F::increment(body, v) } -> std::convertible_to<typename F::Unknown>;
  // a generalised force without what it does to the internal row, and that as a moment in the body frame
  { F::reduced(reduced, force) } -> std::convertible_to<Vector3<typename F::Scalar>>;
  { F::moment(reduced, v) } -> std::convertible_to<Vector3<typename F::Scalar>>;
};

}  // namespace trivium
