#pragma once
/// A mechanism as a graph: bodies are nodes, groups of constraint rows between two bodies are edges. Topology
/// only; what a solver along the graph plans with.

#include <vector>

#include "bodies/numbers/scalar.hpp"
#include "mechanism/mechanism.hpp"

namespace trivium {

/// The rows between two bodies that are treated as one block.
struct GraphEdge : BodyPair {
  static constexpr int most_rows = 6;

  std::vector<int> rows;  ///< of the mechanism
  /// The first three rows hold a point of i on a point of j along the global axes; the others, at most three,
  /// see orientations only.
  bool is_point = false;
  /// The rows see how j moves relative to i and nothing else; a cd of two moving bodies also sees them turn
  /// together.
  bool is_relative = true;
  /// A spring that gives way instead of a row that holds: never part of the tree, its one row stands for none
  /// of the mechanism's.
  bool is_soft = false;

  int size() const { return static_cast<int>(rows.size()); }
};

struct BodyJointGraph {
  int bodies = 0;  ///< the ground is node `bodies`
  std::vector<GraphEdge> edges;
};

/// A joint of any Scalar, as far as the graph sees it.
struct GraphJoint : BodyPair {
  ConstraintType type;
  bool sees_relative_motion;  ///< its first row, and nothing else
  int first_row, rows;
  Vector3<double> axis_i, axis_j;  ///< unit, each in its body's frame
};

/// A joint is an edge; a rotation_driver joins the edge of the revolute whose axis it turns; up to six basic
/// constraints between the same two bodies are one edge, with the point joint beside them where that leaves
/// six rows at most.
BodyJointGraph body_joint_graph(int bodies, const std::vector<GraphJoint>& joints);

template <class Scalar, class Types>
BodyJointGraph body_joint_graph(const Mechanism<Scalar, Types>& mechanism) {
  std::vector<GraphJoint> joints;
  for (const Joint<Scalar>& joint : mechanism.joints)
    joints.push_back({joint, joint.type, sees_relative_motion(mechanism.rows[joint.first_row]),
                      joint.first_row, joint.rows, scalar_cast<double>(joint.frame_i.z),
                      scalar_cast<double>(joint.frame_j.z)});
  return body_joint_graph(mechanism.nb(), joints);
}

}  // namespace trivium
