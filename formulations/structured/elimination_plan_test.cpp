/// The elimination causes no fill-in on trees, and a constant amount per cell on ladders.

#include "formulations/structured/elimination_plan.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <set>
#include <vector>

#include "base/raise.hpp"
#include "bodies/testing/properties.hpp"
#include "formulations/testing/random_mechanism.hpp"
#include "scenes/generators.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/testing/scene_builders.hpp"

namespace trivium {
namespace {

EliminationPlan plan_of(const scenes::Scene& scene) {
  return plan_elimination(body_joint_graph(make_mechanism<double>(scene)));
}
/// Bodies that revolutes connect in the given pairs; -1 is the ground. The geometry has no meaning.
scenes::Scene joined(int bodies, const std::vector<std::array<int, 2>>& pairs) {
  scenes::Scene scene;
  for (int b = 0; b < bodies; ++b) scene.bodies.push_back(test::body("b" + std::to_string(b), 1));
  for (const auto& [i, j] : pairs)
    scene.constraints.push_back(test::joint(JointType::revolute,
                                            "j" + std::to_string(scene.constraints.size()),
                                            test::side(i, scenes::Vector3{}, scenes::Vector3{0, 0, 1}),
                                            test::side(j, scenes::Vector3{}, scenes::Vector3{0, 0, 1})));
  return scene;
}
std::size_t widest_border(const EliminationPlan& plan) {
  std::size_t widest = 0;
  for (const auto& link : plan.links) raise(widest, link.columns.size());
  return widest;
}

TEST(EliminationPlan, TreesFillNothingIn) {
  for (const scenes::Scene& scene : {scenes::chain(50), scenes::tree(200, 7)}) {
    const EliminationPlan plan = plan_of(scene);
    EXPECT_EQ(plan.links.size(), scene.bodies.size());
    EXPECT_EQ(plan.column_slots, 0);
    EXPECT_EQ(plan.coupling_slots, 0);
  }
}

TEST(EliminationPlan, HubIsATree) {
  std::vector<std::array<int, 2>> pairs{{-1, 0}};
  for (int spoke = 1; spoke <= 100; ++spoke) pairs.push_back({0, spoke});
  const EliminationPlan plan = plan_of(joined(101, pairs));
  EXPECT_EQ(plan.column_slots, 0);
  EXPECT_EQ(plan.links.back().body, 0);
}

TEST(EliminationPlan, LinksGoBeforeTheirParents) {
  const EliminationPlan plan = plan_of(scenes::tree(300, 3));
  std::vector<int> place(plan.graph.bodies + 1, static_cast<int>(plan.links.size()));
  for (std::size_t n = 0; n < plan.links.size(); ++n) place[plan.links[n].body] = static_cast<int>(n);
  for (const auto& link : plan.links) EXPECT_LT(place[link.body], place[link.parent]);
}

/// A sum slot belongs to one body from the elimination of its first child to the body's own elimination.
void expect_no_sum_overwrites_another(const EliminationPlan& plan) {
  std::vector<int> owner(plan.sum_slots, -1);
  std::vector<bool> has_children(plan.graph.bodies, false);
  for (const auto& link : plan.links) {
    if (link.parent == plan.graph.bodies) {
      EXPECT_EQ(link.parent_sum_slot, -1);
    } else {
      int& at_parent = owner.at(link.parent_sum_slot);
      EXPECT_EQ(link.is_first, !has_children[link.parent]);
      EXPECT_EQ(at_parent, link.is_first ? -1 : link.parent);
      at_parent = link.parent;
      has_children[link.parent] = true;
    }
    EXPECT_EQ(link.sum_slot >= 0, static_cast<bool>(has_children[link.body]));
    if (link.sum_slot < 0) continue;
    EXPECT_EQ(owner.at(link.sum_slot), link.body);
    owner[link.sum_slot] = -1;
  }
}
TEST(EliminationPlan, NoSumOverwritesAnother) {
  for (const unsigned seed : {1, 2, 3}) expect_no_sum_overwrites_another(plan_of(scenes::tree(300, seed)));
  expect_no_sum_overwrites_another(plan_of(scenes::ladder(20)));
}
TEST(EliminationPlan, AChainSumsInTwoPlaces) { EXPECT_EQ(plan_of(scenes::chain(1000)).sum_slots, 2); }

TEST(EliminationPlan, RingIsHalved) {
  constexpr int n = 41;
  std::vector<std::array<int, 2>> pairs{{-1, 0}, {n - 1, -1}};
  for (int b = 1; b < n; ++b) pairs.push_back({b - 1, b});
  const EliminationPlan plan = plan_of(joined(n, pairs));
  ASSERT_EQ(plan.closings.size(), 1U);
  EXPECT_EQ(widest_border(plan), 1U);
  const auto& closing = plan.graph.edges[plan.closings[0].edge];
  EXPECT_NEAR((closing.i + closing.j) / 2.0, (n - 1) / 2.0, 1);
}

/// Expects that the widest border does not grow with the number of cells, and that the fill-in is linear.
void expect_linear(const std::function<scenes::Scene(int)>& ladder, std::size_t border,
                   double slots_per_cell) {
  for (const int cells : {5, 20, 80}) {
    const EliminationPlan plan = plan_of(ladder(cells));
    EXPECT_LE(widest_border(plan), border) << cells;
    EXPECT_LE(plan.column_slots + plan.coupling_slots, slots_per_cell * cells + 8) << cells;
  }
}

TEST(EliminationPlan, FourBarLadderIsLinear) { expect_linear(scenes::ladder, 2, 6); }

/// A ladder of two rails, both held at their feet, and rungs. With the breadth-first tree alone the loop of
/// every rung would reach down to the ground.
scenes::Scene rails(int cells) {
  std::vector<std::array<int, 2>> pairs{{-1, 0}, {-1, 1}};
  for (int cell = 0; cell < cells; ++cell) {
    const int left = 3 * cell, right = left + 1, rung = left + 2;
    pairs.push_back({left, rung});
    pairs.push_back({rung, right});
    if (cell + 1 == cells) break;
    pairs.push_back({left, left + 3});
    pairs.push_back({right, right + 3});
  }
  return joined(3 * cells, pairs);
}
TEST(EliminationPlan, LadderOfRailsAndRungsIsLinear) { expect_linear(rails, 3, 14); }

TEST(EliminationPlan, EveryRowIsInOneEdge) {
  test::for_all([] {
    const auto mechanism = make_mechanism<double>(test::random_scene(
        *rc::gen::inRange(0, 100000), {.bodies = 4, .closings = 2, .doubled = *rc::gen::inRange(0, 3)}));
    const BodyJointGraph graph = body_joint_graph(mechanism);
    std::multiset<int> rows;
    for (const GraphEdge& edge : graph.edges) {
      RC_ASSERT(edge.size() <= GraphEdge::most_rows);
      rows.insert(edge.rows.begin(), edge.rows.end());
    }
    std::vector<int> all(mechanism.rows.size());
    std::iota(all.begin(), all.end(), 0);
    RC_ASSERT(std::vector<int>(rows.begin(), rows.end()) == all);
  });
}

}  // namespace
}  // namespace trivium
