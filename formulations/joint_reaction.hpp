#pragma once
/// Joint reactions from lambda. With m r'' + Phi_r^T lambda = F and J_bar omega_bar' + Phi_pi_bar^T lambda =
/// n_bar - omega_bar x J_bar omega_bar (Haug 1989, section 11.2), a joint with the rows k acts on a body with
///
///     force = -sum_k Phi_r,k^T lambda_k,   moment = -sum_k Phi_pi_bar,k^T lambda_k
///
/// [N, global; N m, body frame, about the centre of mass]. Here Phi_pi_bar = Phi_rot lift, from the
/// Jacobian of the formulation itself.

#include "bodies/reaction.hpp"
#include "formulations/equations_of_motion.hpp"

namespace trivium {

/// Force [N] and moment [N m] of a joint on its body at `end`, in the global frame, about the centre of mass
/// of this body (for the ground: about the origin). `lambda` has one multiplier per row of the mechanism.
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

/// The point of a joint on its body i [m, global].
template <EquationsAsPrinted F>
Vector3<typename F::Scalar> joint_point(const EquationsOfMotion<F>& eom,
                                        const Joint<typename F::Scalar>& joint) {
  return eom.body[joint.i].point(joint.frame_i.point);
}

}  // namespace trivium
