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

#include "bodies/numbers/lanewise.hpp"
#include "bodies/numbers/register_vectors.hpp"
#include "bodies/numbers/scalar.hpp"
#include "formulations/analysis/rank_tolerance.hpp"
#include "formulations/structured/elimination_plan.hpp"

namespace trivium {

template <class S>
using Vector6 = Vector<S, 6>;
template <class S>
using Matrix6 = Matrix<S, 6, 6>;

/// Six numbers of a body by their parts: translation, rotation.
template <class S>
struct BodyPart {
  Padded<S> r = Padded<S>::Zero(), x = Padded<S>::Zero();

  BodyPart& operator+=(const BodyPart& other) {
    r += other.r;
    x += other.x;
    return *this;
  }
  Vector6<S> six() const {
    Vector6<S> v;
    v.template head<3>() = r.template head<3>();
    v.template tail<3>() = x.template head<3>();
    return v;
  }
  static BodyPart of(const Vector6<S>& v) {
    return {padded<S>(v.template head<3>()), padded<S>(v.template tail<3>())};
  }
};

/// A symmetric 6x6 block by its parts: translation, coupling, rotation.
template <class S>
struct BodyBlock {
  PaddedColumns<S, 3> rr = PaddedColumns<S, 3>::Zero(), rx = rr, xx = rr;
};

/// The rows of a point joint, seen from the child: sign (r_c'' + L_c^T x_c - r_p'' - L_p^T x_p) = gamma for
/// the point and W_c^T x_c + W_p^T x_p = gamma_w for the orientation, a column of W per row. L is the lever:
/// L f is what a force at the point does to a body's rotation.
template <class S>
struct PointRows {
  PaddedColumns<S, 3> L_child = PaddedColumns<S, 3>::Zero(), L_parent = L_child;
  PaddedColumns<S, 3> W_child = L_child, W_parent = L_child;
  S sign{1};  ///< 1 where the child is body j
};

/// Up to six rows on one body: what each multiplier does to it, a column per row.
template <class S>
struct BodyColumns {
  PaddedColumns<S, 6> r = PaddedColumns<S, 6>::Zero(), x = r;

  Matrix6<S> six() const {
    Matrix6<S> C;
    C.template topRows<3>() = r.template topRows<3>();
    C.template bottomRows<3>() = x.template topRows<3>();
    return C;
  }
};

/// The rows of any other edge. Those of a closing may give way by their compliance times their multiplier:
/// Phi a - compliance lambda = gamma.
template <class S>
struct EdgeRows {
  BodyColumns<S> C_i, C_j;
  S compliance{0};
};

/// The matrix. The rows of a point joint in the tree stand in `point`, those of every other edge in `rows`.
template <class S>
struct GraphMatrix {
  std::vector<BodyBlock<S>> H;
  std::vector<PointRows<S>> point;  ///< by link
  std::vector<EdgeRows<S>> rows;    ///< by the plan's rows_slot

  explicit GraphMatrix(const EliminationPlan& plan)
      : H(plan.graph.bodies), point(plan.links.size()), rows(plan.rows_slots) {
    for (std::size_t link = 0; link < point.size(); ++link)
      point[link].sign = S(plan.links[link].body_is_j ? 1 : -1);
  }
};

/// Six numbers per body (and the ground, last) and up to six per edge: a right side, or a solution.
template <class S>
struct GraphVector {
  std::vector<BodyPart<S>> body;
  std::vector<Vector6<S>> edge;

  explicit GraphVector(const BodyJointGraph& graph)
      : body(graph.bodies + 1), edge(graph.edges.size(), Vector6<S>::Zero()) {}

  void add(const S& factor, const GraphVector& other) {
    for (std::size_t b = 0; b < body.size(); ++b) {
      body[b].r += factor * other.body[b].r;
      body[b].x += factor * other.body[b].x;
    }
    for (std::size_t e = 0; e < edge.size(); ++e) edge[e] += factor * other.edge[e];
  }
};

/// The rows of a link as its elimination sees them: those of the one kind or of the other.
template <class S>
struct LinkRows {
  const PointRows<S>& point;
  const BodyColumns<S>& C;  ///< of the body
  const BodyColumns<S>& C_parent;
  int count;
};

/// How a factorisation decides which rows are dependent (tolerances: rank_tolerance.hpp).
enum class DependentRows {
  detect,  ///< those of which nothing is left beside the others
  /// Also those of which so little is left that the elimination alone does not tell it from nothing, as where
  /// a motion passes a singular position; none are restored, and what their right sides say is not asked.
  detect_near_singular,
  /// As decided last. States that leave their constraints by a little, as those within a step of an
  /// integrator, make dependent rows seem independent.
  keep,
  keep_count  ///< as many of each closing as last, whichever are of least effect now; for motions that drift
};

enum class Elimination { done, no_inertia, dependent_rows };

/// What the columns of a closing were made of on their way up, row by row. One that cancelled is its own
/// rounding, and does not show that itself.
template <class S>
struct ColumnSizes {
  Vector6<S> r, x;     ///< the largest squares of its parts
  Vector6<S> product;  ///< what its product with itself (see `couple`) would be if nothing cancelled

  void setZero() {
    r.setZero();
    x.setZero();
    product.setZero();
  }
  void take(int k, const S& r_squared, const S& x_squared) {
    // faster than `larger`: where a part is not a number, neither is the pivot that is held against these
    r[k] = select(r[k] > r_squared, r[k], r_squared);
    x[k] = select(x[k] > x_squared, x[k], x_squared);
  }
};

/// What the multipliers of a closing do at a link: along the free motion, a row of g per row of the closing
/// and 0 beyond; and what is left for the joint to carry (its force, and its moment as far as a moment is
/// carried), a column per row.
template <class S>
struct LinkColumn {
  Matrix6<S> g = Matrix6<S>::Zero();
  PaddedColumns<S, 6> rest_r, rest_x;
};

}  // namespace trivium
