#pragma once
/// Joint reactions as vectors that can be compared: wrenches in the metric of mass and inertia, so that
/// forces and torques are of one unit. Decides which joint reactions are unique, by the null space of the
/// rows.

#include <vector>

#include "formulations/side_by_side.hpp"
#include "mechanism/model.hpp"

namespace trivium {

/// A joint's reaction on either body; see simbody::Answer (solve.hpp).
struct JointReaction {
  Reaction<double> on_i, on_j;
};

/// What both sides' reactions are turned into for comparison.
class ReactionFrame {
 public:
  /// Both must outlive the frame.
  ReactionFrame(const Model<double>& model, const RowAnalysis& rows);

  const Mechanism<double>& mechanism() const { return model_.mechanism; }
  const MatrixX<double>& Phi() const { return Phi_; }

  /// The metric wrenches of all unique joint reactions, then those of all joints together on every body.
  VectorX<double> stack(const std::vector<JointReaction>& reactions) const;

  /// A formulation's reactions: on body j as it gives them, on body i from the rows' gradients there.
  std::vector<JointReaction> reactions(const FormulationResult<double>& result) const;

  /// The lambda of a joint's own rows (independent among themselves) that its reaction stands for.
  VectorX<double> multipliers(const Joint<double>& joint, const JointReaction& reaction) const;

 private:
  using Vector6 = Vector<double, 6>;

  int body_of(const Joint<double>& joint) const;

  /// -Phi^T lambda on body i; nothing on the ground.
  Reaction<double> reaction_on_i(const Joint<double>& joint, const VectorX<double>& lambda) const;

  Vector6 metric_wrench(const Joint<double>& joint, const JointReaction& reaction) const;

  /// Force over sqrt(m) and torque about the centre of mass, body frame, over sqrt(J).
  Vector6 metric_wrench(int body, const Reaction<double>& reaction) const;

  /// No combination of rows that vanishes has a wrench at this joint.
  bool is_unique(const Joint<double>& joint) const;
  int unique_joints() const;

  const Model<double>& model_;
  const RowAnalysis& rows_;
  MatrixX<double> Phi_;
};

}  // namespace trivium
