#pragma once
/// The bodies of a graph that its rows connect with each other, not through the ground.

#include <numeric>
#include <vector>

#include "formulations/structured/body_joint_graph.hpp"

namespace trivium {

/// By body, the ground last: the same number for bodies of one assembly, that of one of them. Springs connect
/// nothing.
inline std::vector<int> assemblies_of(const BodyJointGraph& graph) {
  std::vector<int> assembly(graph.bodies + 1);
  std::iota(assembly.begin(), assembly.end(), 0);
  const auto first = [&](int body) {
    while (assembly[body] != body) body = assembly[body] = assembly[assembly[body]];
    return body;
  };
  for (const GraphEdge& edge : graph.edges)
    if (!edge.is_soft && edge.i != graph.bodies && edge.j != graph.bodies)
      assembly[first(edge.i)] = first(edge.j);
  for (int& body : assembly) body = first(body);
  return assembly;
}

}  // namespace trivium
