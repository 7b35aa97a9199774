/// Removes an edge from every loop, short loops first, and then grows a breadth-first tree from the ground
/// and from each separate part. Short loops are found by a bounded search from both ends of an edge, which
/// keeps the time linear in the size of the graph.

#include "formulations/structured/spanning_forest.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace trivium {

namespace {

/// An edge as seen from one of its nodes; `node` is the other end.
struct Incident {
  int node, edge;
};

/// The graph's edges by node. A removed edge stays in the lists at(), but is_there() is false for it.
class Adjacency {
 public:
  explicit Adjacency(const BodyJointGraph& graph) : edges_(graph.edges), at_(graph.bodies + 1) {
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
      at_[edges_[e].i].push_back({edges_[e].j, e});
      at_[edges_[e].j].push_back({edges_[e].i, e});
    }
    is_there_.assign(edges_.size(), true);
  }
  int nodes() const { return static_cast<int>(at_.size()); }
  int edges() const { return static_cast<int>(edges_.size()); }
  const GraphEdge& edge(int e) const { return edges_[e]; }
  const std::vector<Incident>& at(int node) const { return at_[node]; }
  bool is_there(int e) const { return is_there_[e]; }
  void remove(int e) { is_there_[e] = false; }

 private:
  const std::vector<GraphEdge>& edges_;
  std::vector<std::vector<Incident>> at_;
  std::vector<bool> is_there_;
};

SpanningForest breadth_first(const Adjacency& graph) {
  const int ground = graph.nodes() - 1;
  SpanningForest forest{std::vector<int>(graph.nodes(), ground), std::vector<int>(graph.nodes(), -1), {}, {}};
  std::vector<bool> seen(graph.nodes(), false);
  const auto grow = [&](int root) {
    std::vector<int> queue{root};
    seen[root] = true;
    for (std::size_t head = 0; head < queue.size(); ++head) {
      const int node = queue[head];
      if (node != ground) forest.order.push_back(node);
      for (const Incident& next : graph.at(node)) {
        if (!graph.is_there(next.edge) || seen[next.node]) continue;
        seen[next.node] = true;
        forest.parent[next.node] = node;
        forest.edge[next.node] = next.edge;
        queue.push_back(next.node);
      }
    }
  };
  grow(ground);
  for (int node = 0; node < ground; ++node)
    if (!seen[node]) grow(node);
  return forest;
}

/// The edges of a shortest loop through the given edge. Empty if there is none or if the search would visit
/// more than `reach` edges. The search is breadth-first from both ends and continues at the end whose front
/// has fewer edges. A body with many joints (the ground, a hub) is therefore met before its joints are
/// searched. `reach` bounds the time per edge, so that planning stays linear in the size of the graph. 1000
/// is chosen by experiment: with a smaller value some short loops are not found, and are opened at an
/// unfavourable edge; a larger one costs time.
std::vector<int> shortest_loop(const Adjacency& graph, int through) {
  constexpr std::size_t reach = 1000;
  struct Reached {
    Incident back;  ///< one step back towards the end at which the search began; edge -1 at this end itself
    int distance;   ///< number of edges from this end
  };
  struct Side {
    std::map<int, Reached> reached;
    std::vector<int> front;
    std::size_t edges;  ///< number of edges at the nodes of the front
  };
  const auto side_from = [&](int node) {
    return Side{{{node, {{node, -1}, 0}}}, {node}, graph.at(node).size()};
  };
  Side sides[2]{side_from(graph.edge(through).i), side_from(graph.edge(through).j)};
  for (std::size_t seen = 0; !sides[0].front.empty() && !sides[1].front.empty();) {
    const bool second = sides[1].edges < sides[0].edges;
    Side &side = sides[second], &other = sides[!second];
    seen += side.edges;
    if (seen > reach) return {};
    std::vector<int> front;
    std::optional<int> meeting;
    side.edges = 0;
    for (int node : side.front)
      for (const Incident& next : graph.at(node)) {
        if (next.edge == through || !graph.is_there(next.edge)) continue;
        const Reached here{{node, next.edge}, side.reached.at(node).distance + 1};
        if (!side.reached.emplace(next.node, here).second) continue;
        front.push_back(next.node);
        side.edges += graph.at(next.node).size();
        const auto met = other.reached.find(next.node);
        if (met == other.reached.end()) continue;
        if (!meeting || met->second.distance < other.reached.at(*meeting).distance) meeting = next.node;
      }
    side.front = std::move(front);
    if (!meeting) continue;
    std::vector<int> loop{through};
    for (const Side& part : sides)
      for (Incident back = part.reached.at(*meeting).back; back.edge >= 0;
           back = part.reached.at(back.node).back)
        loop.push_back(back.edge);
    return loop;
  }
  return {};
}

/// Removes edges until no loop is left and returns them. From each short loop the edge with the fewest rows
/// is removed and, among equals, the edge that belongs to the fewest short loops. An edge that two loops
/// share is thus kept, and the two do not merge into a longer one. In a ladder, whose cells are the loops,
/// each link then carries the columns of few cells.
std::vector<int> open_loops(Adjacency& graph) {
  std::vector<int> removed;
  const auto closing_edges = [&] {
    const SpanningForest forest = breadth_first(graph);
    std::vector<bool> in_tree(graph.edges(), false);
    for (int e : forest.edge)
      if (e >= 0) in_tree[e] = true;
    std::vector<int> closing;
    for (int e = 0; e < graph.edges(); ++e)
      if (graph.is_there(e) && !in_tree[e]) closing.push_back(e);
    return closing;
  };
  std::vector<int> closing = closing_edges();
  if (closing.empty()) return removed;
  std::vector<int> uses(graph.edges(), 0);
  for (int e = 0; e < graph.edges(); ++e)
    for (int used : shortest_loop(graph, e)) ++uses[used];
  const auto is_better = [&](int a, int b) {
    return std::pair(graph.edge(a).size(), uses[a]) < std::pair(graph.edge(b).size(), uses[b]);
  };
  for (; !closing.empty(); closing = closing_edges()) {
    bool progress = false;
    for (int e : closing) {
      if (!graph.is_there(e)) continue;
      const std::vector<int> loop = shortest_loop(graph, e);
      if (loop.empty()) continue;
      const int opened = *std::min_element(loop.begin(), loop.end(), is_better);
      graph.remove(opened);
      removed.push_back(opened);
      progress = true;
    }
    if (progress) continue;
    // Only long loops are left. They are opened at the edges outside the breadth-first tree. Such an edge
    // lies in the middle of its loop, at the same distance from the tree's root on both sides, up to one
    // edge.
    for (int e : closing) {
      graph.remove(e);
      removed.push_back(e);
    }
  }
  std::sort(removed.begin(), removed.end());
  return removed;
}

}  // namespace

SpanningForest spanning_forest(const BodyJointGraph& graph) {
  Adjacency adjacency(graph);
  std::vector<int> soft;
  for (int e = 0; e < adjacency.edges(); ++e)
    if (adjacency.edge(e).is_soft) soft.push_back(e);
  for (const int e : soft) adjacency.remove(e);
  std::vector<int> closing_edges = open_loops(adjacency);
  closing_edges.insert(closing_edges.end(), soft.begin(), soft.end());
  SpanningForest forest = breadth_first(adjacency);
  forest.closing_edges = std::move(closing_edges);
  return forest;
}

}  // namespace trivium
