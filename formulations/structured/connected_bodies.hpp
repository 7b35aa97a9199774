#pragma once
/// The connected components of a graph without the ground: sets of bodies that constraint rows connect with
/// each other. Lengths and sizes are compared within a component, never across components.

#include <numeric>
#include <vector>

#include "formulations/structured/body_joint_graph.hpp"

namespace trivium {

/// By body, the ground last: the index of one body of the component, the same for all bodies of a component.
/// Springs (soft edges) do not connect bodies.
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
