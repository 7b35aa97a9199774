/// Makes the lists of the plan one after the other. Links are listed in depth-first order. The loop of each
/// closing is found by climbing from both ends of its edge. Closings are ordered by minimum degree. Then
/// every block gets a slot.

#include "formulations/structured/elimination_plan.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "formulations/structured/spanning_forest.hpp"

namespace trivium {

namespace {

class Planner {
 public:
  explicit Planner(BodyJointGraph graph) : ground_(graph.bodies) {
    plan_.graph = std::move(graph);
    forest_ = spanning_forest(plan_.graph);
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
    // the reversed preorder of a depth-first search eliminates the subtree of a body directly before the
    // body, so that few sums are open at any time
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

  /// The node's place in the order of elimination, which ends with the ground.
  int depth_order(int node) const {
    return node == ground_ ? std::numeric_limits<int>::max() : link_of_[node];
  }

  /// Finds for every closing the links of its loop and the body where the closing is eliminated.
  void find_loops() {
    for (int edge : forest_.closing_edges) {
      const int c = static_cast<int>(plan_.closings.size());
      const GraphEdge& e = plan_.graph.edges[edge];
      plan_.closings.push_back({edge, ground_, -1, -1, -1, {}, {}});
      // Two pointers climb from the ends of the edge to the lowest common ancestor. In each turn the pointer
      // whose node is eliminated earlier moves to the parent.
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
      // If all rows of the loop depend on relative motion only, a rigid motion of the whole loop changes none
      // of them. The motion of the common ancestor then cannot make a dependent row independent, so the
      // decision about the closing's rows can be made at the ancestor. Otherwise the motion of the ancestor
      // may make rows independent, so the closing is eliminated at the ground, and all links from the
      // ancestor to the ground carry its columns.
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

  /// Orders the closings body by body. At each body the closing with the fewest neighbours is next (minimum
  /// degree). Its elimination couples these neighbours with each other.
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

  /// Gives slots to the sums of bodies with children, and frees each slot at the elimination of its body.
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
  SpanningForest forest_;
  std::vector<int> link_of_;                 ///< by body: index of its link
  std::map<std::pair<int, int>, int> slot_;  ///< by closing and body: slot of the closing's block on the body
  std::vector<int> rank_;                    ///< by closing: place in the order of elimination
};

}  // namespace

EliminationPlan plan_elimination(BodyJointGraph graph) { return Planner(std::move(graph)).plan(); }

}  // namespace trivium
