/// Sorts the joints into edges by their pair of bodies. Drivers and basic rows are added to the edge of a
/// joint between the same bodies where they fit.

#include "formulations/structured/body_joint_graph.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "formulations/analysis/rank_tolerance.hpp"

namespace trivium {

namespace {

std::pair<int, int> unordered(const BodyPair& pair) { return std::minmax(pair.i, pair.j); }

/// Whether the driver rotates about the revolute's axis, on both bodies. The axes count as equal if the sine
/// of the angle between them is below standard_rank_tolerance, the sine below which a row counts as
/// dependent.
bool turns(const GraphJoint& driver, const GraphJoint& revolute) {
  const bool swapped = driver.i != revolute.i;
  const auto apart = [](const Vector3<double>& a, const Vector3<double>& b) { return a.cross(b).norm(); };
  return apart(driver.axis_i, swapped ? revolute.axis_j : revolute.axis_i) < standard_rank_tolerance &&
         apart(driver.axis_j, swapped ? revolute.axis_i : revolute.axis_j) < standard_rank_tolerance;
}

}  // namespace

BodyJointGraph body_joint_graph(int bodies, const std::vector<GraphJoint>& joints) {
  BodyJointGraph graph;
  graph.bodies = bodies;
  std::map<std::pair<int, int>, int> basic_edge, point_edge;
  std::map<std::pair<int, int>, std::pair<int, const GraphJoint*>> revolute_edge;
  const auto add_edge = [&](const BodyPair& pair, bool is_point) {
    graph.edges.push_back({pair, {}, is_point, true});
    return static_cast<int>(graph.edges.size()) - 1;
  };
  const auto take_rows = [&](int edge, const GraphJoint& joint) {
    for (int k = 0; k < joint.rows; ++k) graph.edges[edge].rows.push_back(joint.first_row + k);
  };
  std::vector<const GraphJoint*> drivers;
  for (const GraphJoint& joint : joints) {
    const auto pair = unordered(joint);
    const JointProperties type = properties_of(joint.type);
    if (type.drives_an_angle) {
      drivers.push_back(&joint);
    } else if (joint.type.is_basic()) {
      const auto found = basic_edge.find(pair);
      const bool fits = found != basic_edge.end() && graph.edges[found->second].size() < GraphEdge::most_rows;
      if (!fits) basic_edge[pair] = add_edge(joint, false);
      take_rows(basic_edge[pair], joint);
      if (!joint.sees_relative_motion && joint.i != graph.bodies && joint.j != graph.bodies)
        graph.edges[basic_edge[pair]].is_relative = false;
    } else {
      const int edge = add_edge(joint, type.holds_a_point);
      if (type.holds_a_point) point_edge.emplace(pair, edge);
      if (type.holds_a_point && type.has_an_angle) revolute_edge.emplace(pair, std::pair(edge, &joint));
      take_rows(edge, joint);
    }
  }
  // a driver prescribes the rotation that its revolute leaves free, so both form one block of six rows
  for (const GraphJoint* driver : drivers) {
    const auto found = revolute_edge.find(unordered(*driver));
    const bool joins = found != revolute_edge.end() && graph.edges[found->second.first].size() == 5 &&
                       turns(*driver, *found->second.second);
    take_rows(joins ? found->second.first : add_edge(*driver, false), *driver);
  }
  // A point joint alone may leave free a motion without inertia, which the elimination of its link cannot
  // solve. Basic rows between the same bodies may hold this motion, so they join the point joint's edge.
  for (const auto& [pair, basic] : basic_edge) {
    const auto found = point_edge.find(pair);
    if (found == point_edge.end()) continue;
    GraphEdge &joint = graph.edges[found->second], &rows = graph.edges[basic];
    if (joint.size() + rows.size() > GraphEdge::most_rows) continue;
    joint.rows.insert(joint.rows.end(), rows.rows.begin(), rows.rows.end());
    joint.is_point = false;
    joint.is_relative = rows.is_relative;
    rows.rows.clear();
  }
  std::erase_if(graph.edges, [](const GraphEdge& edge) { return edge.rows.empty(); });
  return graph;
}

}  // namespace trivium
