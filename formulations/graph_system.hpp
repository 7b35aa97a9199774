#pragma once
/// The system that is solved along the graph: a symmetric block per body, the rows of every edge, and their
/// right sides.
///
///   H_b a_b + sum over edges of Phi^T lambda = force_b        Phi_i a_i + Phi_j a_j = gamma
///
/// a_b are the six unknowns of a body: r'' and three of rotation, or increments of the like. With H = M it
/// gives accelerations and multipliers; with another H, increments of a projection or of Newton's method.

#include <array>
#include <vector>

#include "bodies/so3.hpp"
#include "formulations/elimination_plan.hpp"

namespace trivium {

template <class S>
using Vector6 = Vector<S, 6>;
template <class S>
using Matrix6 = Matrix<S, 6, 6>;

/// A symmetric 6x6 block by its parts: translation, coupling, rotation.
template <class S>
struct BodyBlock {
  Matrix3<S> rr, rx, xx;
};

/// The rows of a point joint, seen from the child: sign (r_c'' + K_c x_c - r_p'' - K_p x_p) = gamma for the
/// point and W_c^T x_c + W_p^T x_p = gamma_w for the orientation, a column of W per row.
template <class S>
struct PointRows {
  Matrix3<S> K_child, K_parent;
  Matrix3<S> W_child, W_parent;
  S sign{1};  ///< 1 where the child is body j
};

/// The rows of any other edge: a column of C per row and body.
template <class S>
struct EdgeRows {
  Matrix6<S> C_i, C_j;
};

/// The matrix. The rows of a point joint in the tree stand in `point`, those of every other edge in `rows`.
template <class S>
struct GraphMatrix {
  std::vector<BodyBlock<S>> H;
  std::vector<PointRows<S>> point;  ///< by link
  std::vector<EdgeRows<S>> rows;    ///< by edge

  explicit GraphMatrix(const EliminationPlan& plan)
      : H(plan.graph.bodies), point(plan.links.size()), rows(plan.graph.edges.size()) {
    for (EdgeRows<S>& edge : rows) edge = {Matrix6<S>::Zero(), Matrix6<S>::Zero()};
    for (std::size_t link = 0; link < point.size(); ++link) {
      PointRows<S>& p = point[link];
      p.K_child = p.K_parent = p.W_child = p.W_parent = Matrix3<S>::Zero();
      p.sign = S(plan.links[link].body_is_j ? 1 : -1);
    }
  }
};

/// Six numbers per body (and the ground, last) and up to six per edge: a right side, or a solution.
template <class S>
struct GraphVector {
  std::vector<Vector6<S>> body, edge;

  explicit GraphVector(const BodyJointGraph& graph)
      : body(graph.bodies + 1, Vector6<S>::Zero()), edge(graph.edges.size(), Vector6<S>::Zero()) {}
};

/// The rows of a link as its elimination sees them: those of the one kind or of the other.
template <class S>
struct LinkRows {
  const PointRows<S>& point;
  const Matrix6<S>& C;  ///< of the body, a column per row
  const Matrix6<S>& C_parent;
  int count;
};

enum class Elimination { done, no_inertia, binds_the_parent };

/// What the multipliers of a closing do at a link, a column per row: along the free motion, and as a force
/// that is left for the joint.
template <class S>
struct LinkColumn {
  Matrix6<S> g, rest;
};

}  // namespace trivium
