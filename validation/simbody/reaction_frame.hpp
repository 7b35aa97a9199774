#pragma once
/// Joint reactions as vectors that can be compared: wrenches in the metric of mass and inertia, so that
/// forces and torques have the same unit. This file also decides, from the null space of the rows, which
/// joint reactions are unique.

#include <vector>

#include "formulations/side_by_side.hpp"
#include "mechanism/model.hpp"

namespace trivium {

/// The reactions of a joint on its two bodies; see simbody::Answer (solve.hpp).
struct JointReaction {
  Reaction<double> on_i, on_j;
};

/// Converts the reactions of Trivium and of Simbody to the same vectors.
class ReactionFrame {
 public:
  /// Both arguments must outlive this object.
  ReactionFrame(const Model<double>& model, const RowAnalysis& rows);

  const Mechanism<double>& mechanism() const { return model_.mechanism; }
  /// The Jacobian Phi_q = [Phi_r, Phi_pi_bar] of all rows.
  const MatrixX<double>& Phi() const { return Phi_; }

  /// The vector to compare: for every body the metric wrench of all joints together, then the metric wrenches
  /// of all joints whose reactions are unique.
  VectorX<double> stack(const std::vector<JointReaction>& reactions) const;

  /// The reactions of a formulation: on body j from its solution, on body i from the gradients of the rows
  /// and lambda.
  std::vector<JointReaction> reactions(const FormulationResult<double>& result) const;

  /// The lambda of a joint's rows that corresponds to its reaction. The joint's rows must be independent of
  /// each other.
  VectorX<double> multipliers(const Joint<double>& joint, const JointReaction& reaction) const;

 private:
  using Vector6 = Vector<double, 6>;

  int body_of(const Joint<double>& joint) const;

  /// The reaction -Phi_q^T lambda on body i; zero on the ground.
  Reaction<double> reaction_on_i(const Joint<double>& joint, const VectorX<double>& lambda) const;

  Vector6 metric_wrench(const Joint<double>& joint, const JointReaction& reaction) const;

  /// [force / sqrt(m); torque about the centre of mass, body frame, / sqrt(J)].
  Vector6 metric_wrench(int body, const Reaction<double>& reaction) const;

  /// Whether no vector of the rows' null space has a wrench at this joint.
  bool is_unique(const Joint<double>& joint) const;
  int unique_joints() const;

  const Model<double>& model_;
  const RowAnalysis& rows_;
  MatrixX<double> Phi_;
};

}  // namespace trivium
