/// Converts reactions to wrenches about the centre of mass, in the body frame, divided by the scale of
/// accelerations. Multipliers of a joint are solved from its wrench by least squares.

#include "validation/simbody/reaction_frame.hpp"

#include <Eigen/QR>
#include <algorithm>

#include "formulations/analysis/rank_tolerance.hpp"
#include "formulations/analysis/tangent_system.hpp"

namespace trivium {

ReactionFrame::ReactionFrame(const Model<double>& model, const RowAnalysis& rows)
    : model_(model), rows_(rows), Phi_(tangent_system(model.mechanism, model.state).Phi) {}

VectorX<double> ReactionFrame::stack(const std::vector<JointReaction>& reactions) const {
  VectorX<double> out = VectorX<double>::Zero(6 * (mechanism().nb() + unique_joints()));
  Eigen::Index next = 6 * mechanism().nb();
  for (std::size_t k = 0; k < reactions.size(); ++k) {
    const Joint<double>& joint = mechanism().joints[k];
    if (joint.j != mechanism().ground())
      out.segment<6>(6 * joint.j) += metric_wrench(joint.j, reactions[k].on_j);
    if (joint.i != mechanism().ground())
      out.segment<6>(6 * joint.i) += metric_wrench(joint.i, reactions[k].on_i);
    if (!is_unique(joint)) continue;
    out.segment<6>(next) = metric_wrench(joint, reactions[k]);
    next += 6;
  }
  return out;
}

std::vector<JointReaction> ReactionFrame::reactions(const FormulationResult<double>& result) const {
  std::vector<JointReaction> out;
  for (std::size_t k = 0; k < mechanism().joints.size(); ++k)
    out.push_back({reaction_on_i(mechanism().joints[k], result.solution.lambda), result.reactions[k]});
  return out;
}

VectorX<double> ReactionFrame::multipliers(const Joint<double>& joint, const JointReaction& reaction) const {
  const int body = body_of(joint);
  MatrixX<double> B = Phi_.block(joint.first_row, 6 * body, joint.rows, 6).transpose();
  B = rows_.acceleration_scale.segment<6>(6 * body).cwiseInverse().asDiagonal() * B;
  return -B.colPivHouseholderQr().solve(metric_wrench(joint, reaction));
}

int ReactionFrame::body_of(const Joint<double>& joint) const {
  return joint.j != mechanism().ground() ? joint.j : joint.i;
}

Reaction<double> ReactionFrame::reaction_on_i(const Joint<double>& joint,
                                              const VectorX<double>& lambda) const {
  if (joint.i == mechanism().ground()) return {};
  const Pose<double>& pose = model_.state.pose[static_cast<std::size_t>(joint.i)];
  const Vector6 wrench = -Phi_.block(joint.first_row, 6 * joint.i, joint.rows, 6).transpose() *
                         lambda.segment(joint.first_row, joint.rows);
  return {wrench.head<3>(), rotation_matrix(pose.p) * wrench.tail<3>(), pose.r};
}

ReactionFrame::Vector6 ReactionFrame::metric_wrench(const Joint<double>& joint,
                                                    const JointReaction& reaction) const {
  const int body = body_of(joint);
  return metric_wrench(body, body == joint.j ? reaction.on_j : reaction.on_i);
}

ReactionFrame::Vector6 ReactionFrame::metric_wrench(int body, const Reaction<double>& reaction) const {
  const Pose<double>& pose = model_.state.pose[static_cast<std::size_t>(body)];
  const Reaction<double> moved = reaction.about(pose.r);
  Vector6 wrench;
  wrench << moved.force, rotation_matrix(pose.p).transpose() * moved.torque;
  return wrench.cwiseQuotient(rows_.acceleration_scale.segment<6>(6 * body));
}

bool ReactionFrame::is_unique(const Joint<double>& joint) const {
  if (rows_.dependent.empty()) return true;
  const MatrixX<double> wrench = Phi_.middleRows(joint.first_row, joint.rows).transpose() *
                                 rows_.null_basis.middleRows(joint.first_row, joint.rows);
  const MatrixX<double> scaled = rows_.acceleration_scale.cwiseInverse().asDiagonal() * wrench;
  return scaled.norm() <= standard_rank_tolerance;
}

int ReactionFrame::unique_joints() const {
  return static_cast<int>(std::count_if(mechanism().joints.begin(), mechanism().joints.end(),
                                        [this](const Joint<double>& j) { return is_unique(j); }));
}

}  // namespace trivium
