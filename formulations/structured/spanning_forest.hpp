#pragma once
/// Which edges of a graph span its bodies, and which close loops. Decided here: breadth first from the
/// ground, which keeps loops short; on their length the fill of the elimination depends.

#include <vector>

#include "formulations/structured/body_joint_graph.hpp"

namespace trivium {

/// Breadth first from the ground, then from the first body of every part that the ground does not hold.
struct SpanningForest {
  std::vector<int> parent, edge;   ///< by node; edge -1 and parent the ground where a body hangs on nothing
  std::vector<int> order;          ///< bodies, parents first
  std::vector<int> closing_edges;  ///< the others; soft edges, which never span, last
};

SpanningForest spanning_forest(const BodyJointGraph& graph);

}  // namespace trivium
