#pragma once
/// Divides the edges of a graph into those of a spanning forest and those that close loops. The fill-in of
/// the elimination grows with the length of the loops, so the forest is chosen such that loops are short.

#include <vector>

#include "formulations/structured/body_joint_graph.hpp"

namespace trivium {

/// One tree is rooted at the ground. Each part of the mechanism that no path of edges connects to the ground
/// has a tree of its own, rooted at the part's first body.
struct SpanningForest {
  std::vector<int> parent, edge;   ///< by node: the parent and the edge to it; a root has the ground and -1
  std::vector<int> order;          ///< the bodies, each parent before its children
  std::vector<int> closing_edges;  ///< the edges outside the forest; all soft edges are among them, last
};

/// The forest of a graph, in time linear in the size of the graph.
SpanningForest spanning_forest(const BodyJointGraph& graph);

}  // namespace trivium
