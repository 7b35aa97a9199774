#pragma once
/// A mechanism as a graph: the bodies are nodes, the groups of constraint rows between two bodies are edges.
/// The graph holds the topology only, no numbers. The structured solver plans its elimination on it.

#include <vector>

#include "bodies/numbers/scalar.hpp"
#include "mechanism/mechanism.hpp"

namespace trivium {

/// An edge: rows between the bodies i and j that the solver treats as one block.
struct GraphEdge : BodyPair {
  static constexpr int most_rows = 6;

  std::vector<int> rows;  ///< indices of the edge's rows in the mechanism
  /// The first three rows hold a point of i on a point of j along the global axes. The further rows, at most
  /// three, depend on the orientations only.
  bool is_point = false;
  /// The rows constrain the motion of j relative to i only. A single cd row between two moving bodies does
  /// not: its direction is fixed in the global frame. The three cd rows of a point joint do, because d_ij = 0
  /// in every frame.
  bool is_relative = true;
  /// The edge is a spring (a row with compliance), not a constraint. A soft edge never belongs to the
  /// spanning tree, and the one entry of `rows` is no row of the mechanism.
  bool is_soft = false;

  int size() const { return static_cast<int>(rows.size()); }
};

/// Bodies as nodes and groups of rows as edges.
struct BodyJointGraph {
  int bodies = 0;  ///< the ground is node `bodies`
  std::vector<GraphEdge> edges;
  double rank_tolerance = standard_rank_tolerance;  ///< of the mechanism
};

/// The properties of a joint that decide about edges. They do not depend on the mechanism's Scalar.
struct GraphJoint : BodyPair {
  ConstraintType type;
  bool sees_relative_motion;       ///< the joint's first row depends on relative motion only
  int first_row, rows;             ///< index of the first row in the mechanism, number of rows
  Vector3<double> axis_i, axis_j;  ///< unit vectors along the joint's z axis, each in the frame of its body
};

/// Each joint becomes an edge, with three exceptions. A rotation_driver joins the edge of the revolute about
/// whose axis it rotates. Up to six basic constraints between the same two bodies form one edge. If a point
/// joint connects the same bodies, these constraints join its edge, if both together have at most six rows;
/// the edge then no longer counts as a point edge.
BodyJointGraph body_joint_graph(int bodies, const std::vector<GraphJoint>& joints);

/// The graph of a mechanism.
template <class Scalar, class Types>
BodyJointGraph body_joint_graph(const Mechanism<Scalar, Types>& mechanism) {
  std::vector<GraphJoint> joints;
  for (const Joint<Scalar>& joint : mechanism.joints)
    joints.push_back({joint, joint.type, sees_relative_motion(mechanism.rows[joint.first_row]),
                      joint.first_row, joint.rows, scalar_cast<double>(joint.frame_i.z),
                      scalar_cast<double>(joint.frame_j.z)});
  BodyJointGraph graph = body_joint_graph(mechanism.nb(), joints);
  graph.rank_tolerance = mechanism.rank_tolerance;
  return graph;
}

}  // namespace trivium
