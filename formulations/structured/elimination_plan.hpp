#pragma once
/// The symbolic part of the structured solver: the spanning tree, the order of elimination, the body at which
/// each loop is closed, and the blocks that fill in. A plan is made once per mechanism, and the numeric
/// factorisation follows its lists.
///
/// A link is a body with the joint to its parent in the tree. Links are eliminated from the leaves to the
/// root, which causes no fill-in. A closing is an edge outside the tree and closes a loop. While the links of
/// the loop are eliminated, the closing's multipliers stay unknown: each of these links carries them as a
/// border of extra columns. The closing is eliminated after the last link of the loop: at the lowest common
/// ancestor of the loop's bodies, or at the ground if a row of the loop depends on absolute motion.

#include <vector>

#include "formulations/structured/body_joint_graph.hpp"

namespace trivium {

/// The order of the elimination, with the storage slot of every block.
struct EliminationPlan {
  // a slot is an index into the solver's storage for blocks of one kind

  /// The block [6 x rows] of a closing on a link's body: the generalised forces per unit multiplier.
  struct Column {
    int closing;
    int slot;         ///< slot of the block on this body
    int parent_slot;  ///< slot of the block on the parent; -1 if the parent is the ground
  };
  /// The coupling block of two closings that pass the same link.
  struct Coupling {
    int first,
        second;  ///< indices into the link's columns, in the order of elimination; equal on the diagonal
    int slot;    ///< slot of the block, whose rows are those of the closing `first`
  };
  /// A body and the joint to its parent.
  struct Link {
    int body;
    int parent;  ///< the parent body; graph.bodies stands for the ground
    int edge;    ///< the joint to the parent; -1 if the body has none and floats freely
    bool body_is_j;
    bool is_first = false;  ///< the first link to be eliminated into this parent
    // The sum of a body is its own block plus the blocks that its children pass up. It has a slot from the
    // elimination of the first child to the elimination of the body. Then the slot is free for another body.
    int sum_slot = -1;         ///< slot of the body's sum; -1 if the body has no children
    int parent_sum_slot = -1;  ///< slot of the parent's sum; -1 if the parent is the ground
    std::vector<Column> columns;
    std::vector<Coupling> couplings;
  };
  /// A closing n that is coupled with a closing c and eliminated after c. c lists it in `later`.
  struct Neighbour {
    int closing;      ///< n
    int slot;         ///< slot of the coupling of c and n
    int column_slot;  ///< slot of the block of n on the body where c is eliminated; -1 on the ground
  };
  /// A coupling that the elimination of a closing changes. It couples two entries of the list `later`.
  struct Fill {
    int first, second, slot;  ///< two indices into `later`, slot of their coupling
  };
  /// An edge outside the tree.
  struct Closing {
    int edge;
    int body;            ///< the body where the closing is eliminated; graph.bodies stands for the ground
    int column_slot;     ///< slot of the closing's block on this body; -1 on the ground
    int slot_i, slot_j;  ///< slots of the closing's blocks on the edge's bodies i and j; -1 on the ground
    std::vector<Neighbour> later;  ///< coupled closings that are eliminated later
    std::vector<Fill> fill;        ///< all pairs of `later`, each closing with itself included
  };
  /// A step of the elimination: all closings of a body, then the body's link.
  struct Step {
    int link;                   ///< -1 in the last step, which eliminates the closings of the ground
    std::vector<int> closings;  ///< in the order of elimination
  };

  /// Whether the joint of the link is a point joint.
  bool is_point_link(const Link& link) const { return link.edge >= 0 && graph.edges[link.edge].is_point; }

  BodyJointGraph graph;
  std::vector<Link> links;  ///< in the order of elimination, from the leaves to the roots
  std::vector<Closing> closings;
  std::vector<Step> steps;
  std::vector<int> diagonal_slot;  ///< by closing: slot of its diagonal block among the couplings
  std::vector<int> rows_slot;      ///< by edge: slot in GraphMatrix::rows; -1 for point joints of the tree
  int rows_slots = 0, column_slots = 0, coupling_slots = 0, sum_slots = 0;
};

/// Plans the elimination: a spanning tree with short loops, and for the closings at each body an order of
/// minimum degree, which keeps the fill-in small.
EliminationPlan plan_elimination(BodyJointGraph graph);

}  // namespace trivium
