/// Copies accelerations, multipliers and reactions. A joint that is a mobilizer has no multipliers in
/// Simbody; they are computed from its reaction.

#include "validation/simbody/simbody_solution.hpp"

namespace trivium {

namespace {

Vector3<double> eigen(const simbody::Vector3& v) { return {v[0], v[1], v[2]}; }

Reaction<double> eigen(const simbody::Reaction& r) {
  return {eigen(r.force), eigen(r.torque), eigen(r.point)};
}

}  // namespace

SimbodySolution to_trivium_solution(const simbody::Model& model, const simbody::Answer& answer,
                                    const ReactionFrame& frame) {
  SimbodySolution out;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    out.solution.r_ddot.push_back(eigen(answer.r_ddot[b]));
    out.solution.omega_bar_dot.push_back(eigen(answer.omega_bar_dot[b]));
  }
  out.solution.lambda = Eigen::Map<const VectorX<double>>(answer.lambda.data(), frame.mechanism().nc());
  const Mechanism<double>& mechanism = frame.mechanism();
  for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
    const Joint<double>& joint = mechanism.joints[k];
    const JointReaction reaction{eigen(answer.reactions_on_i[k]), eigen(answer.reactions_on_j[k])};
    if (!answer.lambda_known[static_cast<std::size_t>(joint.first_row)])
      out.solution.lambda.segment(joint.first_row, joint.rows) = frame.multipliers(joint, reaction);
    out.reactions.push_back(reaction);
  }
  return out;
}

}  // namespace trivium
