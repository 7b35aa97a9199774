#pragma once
/// Joint reactions from lambda. With M r'' + Phi_r^T lambda = F, a joint acts on a body with the force
/// -Phi_r^T lambda [N, global] and the moment -Phi_pi_bar^T lambda about the centre of mass [N m, body
/// frame]. Here Phi_pi_bar = Phi_rot lift, from the Jacobian of the formulation itself.

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
