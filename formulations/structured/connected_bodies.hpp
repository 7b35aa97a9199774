#pragma once
/// The connected components of a graph: bodies that its rows connect with each other, not through the ground.
/// Lengths and sizes are compared within a component.

#include <numeric>
#include <vector>

#include "formulations/structured/body_joint_graph.hpp"

namespace trivium {

/// By body, the ground last: the same number for bodies of one component, that of one of them. Springs
/// connect nothing.
inline std::vector<int> components_of(const BodyJointGraph& graph) {
  std::vector<int> component(graph.bodies + 1);
  std::iota(component.begin(), component.end(), 0);
  const auto first = [&](int body) {
    while (component[body] != body) body = component[body] = component[component[body]];
    return body;
  };
  for (const GraphEdge& edge : graph.edges)
    if (!edge.is_soft && edge.i != graph.bodies && edge.j != graph.bodies)
      component[first(edge.i)] = first(edge.j);
  for (int& body : component) body = first(body);
  return component;
}

}  // namespace trivium
