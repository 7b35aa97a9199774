#pragma once
/// The symbolic half of the solver along the graph: which joints span the tree, in which order its links are
/// eliminated, where loops close and which blocks fill in. Made once per mechanism; numeric work only walks
/// its lists.
///
/// A link is a body with the joint to its parent. Links go from the leaves to the root, so the tree fills
/// nothing in. A joint outside the tree closes a loop: its multipliers wait in the border of every link on
/// the loop, and go as soon as the loop's links are gone, at the lowest body that they have in common.

#include <vector>

#include "formulations/structured/body_joint_graph.hpp"

namespace trivium {

struct EliminationPlan {
  /// The columns of a closing edge on one body: what its multipliers do to it.
  struct Column {
    int closing;
    int slot;         ///< of the 6 x rows block on this body
    int parent_slot;  ///< of the block on the parent; -1 where that is the ground
  };
  /// The coupling of two closings (first eliminated first) that share a link.
  struct Coupling {
    int first, second;  ///< indices into the link's columns
    int slot;           ///< of the block, rows of the closing eliminated first
  };
  struct Link {
    int body;
    int parent;  ///< graph.bodies: the ground
    int edge;    ///< the joint to the parent, -1: none, the body is free
    bool body_is_j;
    bool is_first = false;  ///< of the links eliminated into the parent
    // where a body gathers what its links pass on, from the first of them to its own; then it is another's
    int sum_slot = -1;         ///< -1: no links were eliminated into the body
    int parent_sum_slot = -1;  ///< -1: the ground
    std::vector<Column> columns;
    std::vector<Coupling> couplings;
  };
  struct Neighbour {
    int closing;
    int slot;         ///< of the coupling with it
    int column_slot;  ///< of its block on the body where this one is eliminated, -1: on the ground
  };
  /// What eliminating a closing adds to the coupling of two of its neighbours.
  struct Fill {
    int first, second, slot;  ///< indices into neighbours, slot of their coupling
  };
  struct Closing {
    int edge;
    int body;            ///< the lowest body that its loop's links have in common; graph.bodies: the ground
    int column_slot;     ///< of its block there, -1: on the ground
    int slot_i, slot_j;  ///< of its blocks on its own bodies, -1: the ground
    std::vector<Neighbour> later;  ///< coupled closings that are eliminated after it
    std::vector<Fill> fill;        ///< over all pairs of `later`, a closing with itself among them
  };
  /// One step: all closings of a body, then its link.
  struct Step {
    int link;                   ///< -1: the ground, last
    std::vector<int> closings;  ///< in this order
  };

  bool is_point_link(const Link& link) const { return link.edge >= 0 && graph.edges[link.edge].is_point; }

  BodyJointGraph graph;
  std::vector<Link> links;  ///< leaves to root
  std::vector<Closing> closings;
  std::vector<Step> steps;
  std::vector<int> diagonal_slot;  ///< per closing: its block with itself
  std::vector<int> rows_slot;      ///< per edge: of its rows in the matrix; -1: a point joint in the tree
  int rows_slots = 0, column_slots = 0, coupling_slots = 0, sum_slots = 0;
};

/// Chooses the spanning tree so that loops stay short, and orders what closes them by least fill.
EliminationPlan plan_elimination(BodyJointGraph graph);

}  // namespace trivium
