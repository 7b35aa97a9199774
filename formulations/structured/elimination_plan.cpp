#include "formulations/structured/elimination_plan.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

namespace trivium {

namespace {

struct Incident {
  int node, edge;
};

/// The edges of a graph that are still there, by node.
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

/// A spanning forest: breadth first from the ground, then from the first body of every part that the ground
/// does not hold.
struct Forest {
  std::vector<int> parent, edge;  ///< by node; edge -1 and parent the ground where a body hangs on nothing
  std::vector<int> order;         ///< bodies, parents first
};

Forest breadth_first(const Adjacency& graph) {
  const int ground = graph.nodes() - 1;
  Forest forest{std::vector<int>(graph.nodes(), ground), std::vector<int>(graph.nodes(), -1), {}};
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

/// The edges of a shortest loop through an edge, searched from both its ends, so that a body with many joints
/// (the ground) is met and not searched through; none where that looks at more than `reach` edges.
std::vector<int> shortest_loop(const Adjacency& graph, int through) {
  constexpr std::size_t reach = 1000;
  struct Reached {
    Incident back;  ///< towards the end of the edge that it was reached from
    int distance;
  };
  struct Side {
    std::map<int, Reached> reached;
    std::vector<int> front;
    std::size_t edges;  ///< of the front
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

/// Removes edges until no loop is left. Each short loop loses the edge with the fewest rows and, among those,
/// the one that the fewest short loops use: neighbouring loops stay apart, and the border of a ladder stays
/// as wide as one of its cells.
std::vector<int> open_loops(Adjacency& graph) {
  std::vector<int> removed;
  const auto closing_edges = [&] {
    const Forest forest = breadth_first(graph);
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
    // only long loops are left: where breadth-first search meets itself they are halved
    for (int e : closing) {
      graph.remove(e);
      removed.push_back(e);
    }
  }
  std::sort(removed.begin(), removed.end());
  return removed;
}

class Planner {
 public:
  explicit Planner(BodyJointGraph graph) : ground_(graph.bodies) {
    plan_.graph = std::move(graph);
    Adjacency adjacency(plan_.graph);
    std::vector<int> soft;
    for (int e = 0; e < adjacency.edges(); ++e)
      if (adjacency.edge(e).is_soft) soft.push_back(e);
    for (const int e : soft) adjacency.remove(e);
    closing_edges_ = open_loops(adjacency);
    closing_edges_.insert(closing_edges_.end(), soft.begin(), soft.end());
    forest_ = breadth_first(adjacency);
  }

  EliminationPlan plan() {
    order_links();
    find_loops();
    order_closings();
    list_sums();
    list_rows();
    list_couplings();
    return std::move(plan_);
  }

 private:
  void order_links() {
    // depth first, so that what hangs on a body is done shortly before it
    std::vector<std::vector<int>> children(ground_ + 1);
    for (int body : forest_.order) children[forest_.parent[body]].push_back(body);
    std::vector<int> stack{ground_}, preorder;
    while (!stack.empty()) {
      const int node = stack.back();
      stack.pop_back();
      if (node != ground_) preorder.push_back(node);
      stack.insert(stack.end(), children[node].begin(), children[node].end());
    }
    link_of_.assign(ground_ + 1, -1);
    for (auto body = preorder.rbegin(); body != preorder.rend(); ++body) {
      const int edge = forest_.edge[*body];
      link_of_[*body] = static_cast<int>(plan_.links.size());
      plan_.links.push_back({*body,
                             forest_.parent[*body],
                             edge,
                             edge >= 0 && plan_.graph.edges[edge].j == *body,
                             false,
                             -1,
                             -1,
                             {},
                             {}});
    }
  }

  int depth_order(int node) const {
    return node == ground_ ? std::numeric_limits<int>::max() : link_of_[node];
  }

  /// Every closing's links, and the body where they meet.
  void find_loops() {
    for (int edge : closing_edges_) {
      const int c = static_cast<int>(plan_.closings.size());
      const GraphEdge& e = plan_.graph.edges[edge];
      plan_.closings.push_back({edge, ground_, -1, -1, -1, {}, {}});
      // of two nodes the one that is eliminated earlier moves to its parent
      int a = e.i, b = e.j;
      std::vector<int> path;
      bool is_relative = e.is_relative;
      while (a != b) {
        int& lower = depth_order(a) < depth_order(b) ? a : b;
        path.push_back(link_of_[lower]);
        const int joint = plan_.links[link_of_[lower]].edge;
        is_relative = is_relative && (joint < 0 || plan_.graph.edges[joint].is_relative);
        lower = forest_.parent[lower];
      }
      // where any row of the loop sees absolute motion, what it leaves is settled only when no body is left
      for (; !is_relative && a != ground_; a = forest_.parent[a]) path.push_back(link_of_[a]);
      std::sort(path.begin(), path.end());
      plan_.closings[c].body = a;
      for (int link : path) slot_[{c, plan_.links[link].body}] = plan_.column_slots++;
      if (a != ground_) slot_[{c, a}] = plan_.column_slots++;
      for (int link : path) {
        const EliminationPlan::Link& l = plan_.links[link];
        plan_.links[link].columns.push_back({c, slot_of(c, l.body), slot_of(c, l.parent)});
      }
      plan_.closings[c].column_slot = slot_of(c, a);
      plan_.closings[c].slot_i = slot_of(c, e.i);
      plan_.closings[c].slot_j = slot_of(c, e.j);
    }
  }
  int slot_of(int closing, int body) const {
    const auto found = slot_.find({closing, body});
    return found == slot_.end() ? -1 : found->second;
  }

  /// Body by body; at each, the closing with the fewest neighbours first.
  void order_closings() {
    const int n = static_cast<int>(plan_.closings.size());
    std::vector<std::set<int>> neighbours(n);
    for (const EliminationPlan::Link& link : plan_.links)
      for (const auto& a : link.columns)
        for (const auto& b : link.columns)
          if (a.closing != b.closing) neighbours[a.closing].insert(b.closing);
    std::vector<std::vector<int>> at(ground_ + 1);
    for (int c = 0; c < n; ++c) at[plan_.closings[c].body].push_back(c);
    rank_.assign(n, -1);
    int next_rank = 0;
    const auto eliminate_at = [&](int body) {
      std::set<std::pair<std::size_t, int>> by_degree;
      for (int c : at[body]) by_degree.insert({neighbours[c].size(), c});
      std::vector<int> order;
      while (!by_degree.empty()) {
        const int c = by_degree.begin()->second;
        by_degree.erase(by_degree.begin());
        rank_[c] = next_rank++;
        order.push_back(c);
        const std::set<int> left = neighbours[c];
        for (int a : left) {
          const auto before = by_degree.find({neighbours[a].size(), a});
          const bool queued = before != by_degree.end();
          if (queued) by_degree.erase(before);
          neighbours[a].erase(c);
          for (int b : left)
            if (a != b) neighbours[a].insert(b);
          if (queued) by_degree.insert({neighbours[a].size(), a});
          plan_.closings[c].later.push_back({a, -1, slot_of(a, body)});
        }
      }
      return order;
    };
    for (int link = 0; link < static_cast<int>(plan_.links.size()); ++link)
      plan_.steps.push_back({link, eliminate_at(plan_.links[link].body)});
    if (!at[ground_].empty()) plan_.steps.push_back({-1, eliminate_at(ground_)});
  }

  void list_sums() {
    std::vector<int> slot(plan_.graph.bodies + 1, -1), free;
    for (EliminationPlan::Link& link : plan_.links) {
      if (link.parent != ground_) {
        int& at_parent = slot[link.parent];
        link.is_first = at_parent < 0;
        if (link.is_first && free.empty()) free.push_back(plan_.sum_slots++);
        if (link.is_first) {
          at_parent = free.back();
          free.pop_back();
        }
        link.parent_sum_slot = at_parent;
      }
      link.sum_slot = slot[link.body];
      if (link.sum_slot >= 0) free.push_back(link.sum_slot);
    }
  }

  void list_rows() {
    plan_.rows_slot.assign(plan_.graph.edges.size(), 0);
    for (const EliminationPlan::Link& link : plan_.links)
      if (plan_.is_point_link(link)) plan_.rows_slot[link.edge] = -1;
    for (int& slot : plan_.rows_slot)
      if (slot == 0) slot = plan_.rows_slots++;
  }

  void list_couplings() {
    for (std::size_t c = 0; c < plan_.closings.size(); ++c)
      plan_.diagonal_slot.push_back(plan_.coupling_slots++);
    std::map<std::pair<int, int>, int> slot;
    const auto coupling = [&](int a, int b) {
      if (a == b) return plan_.diagonal_slot[a];
      const auto [it, is_new] = slot.try_emplace(std::pair(a, b), plan_.coupling_slots);
      if (is_new) ++plan_.coupling_slots;
      return it->second;
    };
    for (EliminationPlan::Link& link : plan_.links) {
      std::sort(link.columns.begin(), link.columns.end(),
                [&](const auto& a, const auto& b) { return rank_[a.closing] < rank_[b.closing]; });
      for (int a = 0; a < static_cast<int>(link.columns.size()); ++a)
        for (int b = a; b < static_cast<int>(link.columns.size()); ++b)
          link.couplings.push_back({a, b, coupling(link.columns[a].closing, link.columns[b].closing)});
    }
    for (int c = 0; c < static_cast<int>(plan_.closings.size()); ++c) {
      auto& later = plan_.closings[c].later;
      std::sort(later.begin(), later.end(),
                [&](const auto& a, const auto& b) { return rank_[a.closing] < rank_[b.closing]; });
      for (int a = 0; a < static_cast<int>(later.size()); ++a) {
        later[a].slot = coupling(c, later[a].closing);
        for (int b = a; b < static_cast<int>(later.size()); ++b)
          plan_.closings[c].fill.push_back({a, b, coupling(later[a].closing, later[b].closing)});
      }
    }
  }

  const int ground_;
  EliminationPlan plan_;
  std::vector<int> closing_edges_;
  Forest forest_;
  std::vector<int> link_of_;                 ///< by body
  std::map<std::pair<int, int>, int> slot_;  ///< by closing and body
  std::vector<int> rank_;                    ///< by closing: its place in the order of elimination
};

}  // namespace

EliminationPlan plan_elimination(BodyJointGraph graph) { return Planner(std::move(graph)).plan(); }

}  // namespace trivium
