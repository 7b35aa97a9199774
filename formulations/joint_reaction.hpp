#pragma once
/// From lambda to joint reactions. With M r'' + Phi_r^T lambda = F, the force of a joint on a body is
/// -Phi_r^T lambda and its moment about the centre of mass -Phi_pi_bar^T lambda in the body frame; here
/// Phi_pi_bar comes from the formulation's own Jacobian, Phi_rot lift.

#include "bodies/reaction.hpp"
#include "formulations/equations_of_motion.hpp"

namespace trivium {

/// The reaction of one joint on the body at one end: global frame, about that body's centre of mass (the
/// ground's is the origin).
template <EquationsAsPrinted F>
Reaction<typename F::Scalar> joint_reaction(const EquationsOfMotion<F>& eom,
                                            const Joint<typename F::Scalar>& joint,
                                            const VectorX<typename F::Scalar>& lambda, End end) {
  using S = typename F::Scalar;
  const auto& body = eom.body[end == End::i ? joint.i : joint.j];
  Vector3<S> force = Vector3<S>::Zero();
  typename F::Unknown rotational = F::Unknown::Zero();
  for (int k = joint.first_row; k < joint.first_row + joint.rows; ++k) {
    const auto& row = eom.row[k];
    force -= lambda[k] * (end == End::i ? row.r_i : row.r_j).transpose();
    rotational -= lambda[k] * (end == End::i ? row.rot_i : row.rot_j).transpose();
  }
  return {force, body.A * (F::lift(body).transpose() * rotational), body.r};
}

/// The global position of a joint's point on body i.
template <EquationsAsPrinted F>
Vector3<typename F::Scalar> joint_point(const EquationsOfMotion<F>& eom,
                                        const Joint<typename F::Scalar>& joint) {
  return eom.body[joint.i].point(joint.frame_i.point);
}

}  // namespace trivium
