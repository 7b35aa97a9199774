#pragma once
/// The linear system of the structured solver: a symmetric block H_b per body b and the rows of each edge
/// (bodies i, j), with their right sides.
///
///     H_b a_b + sum over edges of Phi^T lambda = force_b        Phi_i a_i + Phi_j a_j = gamma
///
/// a_b has the six unknowns of a body: r'' and three rotational unknowns x, or increments of both. With H = M
/// the solution is the accelerations and multipliers. With other H it is an increment of a projection or of a
/// Newton iteration. A wrench on a body has the same two parts: a force, and a generalised force on x.

#include <array>
#include <vector>

#include "bodies/numbers/lanewise.hpp"
#include "bodies/numbers/register_vectors.hpp"
#include "bodies/numbers/scalar.hpp"
#include "formulations/analysis/rank_tolerance.hpp"
#include "formulations/structured/elimination_plan.hpp"

namespace trivium {

/// A column of 6 numbers.
template <class S>
using Vector6 = Vector<S, 6>;
/// A matrix [6x6].
template <class S>
using Matrix6 = Matrix<S, 6, 6>;

/// Six numbers of a body in two parts: translation r, rotation x. Each part is padded to a vector register.
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

/// A symmetric block [6x6] in parts [3x3]: translation rr, coupling rx, rotation xx.
template <class S>
struct BodyBlock {
  PaddedColumns<S, 3> rr = PaddedColumns<S, 3>::Zero(), rx = rr, xx = rr;
};

/// The rows of a point joint of the tree, between the child c and its parent p:
///
///     sign (r_c'' + L_c^T x_c - r_p'' - L_p^T x_p) = gamma      W_c^T x_c + W_p^T x_p = gamma_w
///
/// for the point (three rows) and for the orientation (up to three rows, one column of W each). L is the
/// lever matrix: L f is the generalised force on x of a force f that acts on the body at the point.
template <class S>
struct PointRows {
  PaddedColumns<S, 3> L_child = PaddedColumns<S, 3>::Zero(), L_parent = L_child;
  PaddedColumns<S, 3> W_child = L_child, W_parent = L_child;
  S sign{1};  ///< 1 if the child is body j, -1 if it is body i
};

/// Up to six rows on one body, transposed: column k is the wrench of row k per unit multiplier.
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

/// The rows of an edge that is no point joint of the tree. The rows of a closing may have a compliance
/// (springs): Phi a - compliance lambda = gamma.
template <class S>
struct EdgeRows {
  BodyColumns<S> C_i, C_j;
  S compliance{0};
};

/// The matrix. `point` holds the rows of the point joints of the tree, `rows` those of all other edges.
template <class S>
struct GraphMatrix {
  std::vector<BodyBlock<S>> H;
  std::vector<PointRows<S>> point;  ///< by link
  std::vector<EdgeRows<S>> rows;    ///< by EliminationPlan::rows_slot

  explicit GraphMatrix(const EliminationPlan& plan)
      : H(plan.graph.bodies), point(plan.links.size()), rows(plan.rows_slots) {
    for (std::size_t link = 0; link < point.size(); ++link)
      point[link].sign = S(plan.links[link].body_is_j ? 1 : -1);
  }
};

/// Six numbers per body (the ground last) and up to six per edge: forces and gamma, or a and lambda.
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

/// The rows of a link's joint. A PointLink reads `point` only, a GeneralLink the other three members.
template <class S>
struct LinkRows {
  const PointRows<S>& point;
  const BodyColumns<S>& C;  ///< the rows on the link's own body
  const BodyColumns<S>& C_parent;
  int count;
};

/// How a factorisation decides which rows are dependent (tolerances: rank_tolerance.hpp).
enum class DependentRows {
  detect,  ///< rows whose gradient is, up to the tolerance, a linear combination of the others
  /// The rows of `detect`, and nearly dependent rows, which the pivots alone cannot distinguish from
  /// dependent ones. No candidate is put back and no right side is checked. For motions through singular
  /// positions.
  detect_near_singular,
  /// The rows of the last decision, and rows whose pivot is rounding. Rows that the decision put back are
  /// bordered again. At a state that violates its
  /// constraints a little, as the stages of an integrator do, a new decision would take dependent rows for
  /// independent ones.
  keep,
  /// As many dependent rows in each closing as in the last decision, but not necessarily the same: those that
  /// now have the smallest pivots. For motions that drift from their constraints.
  keep_count
};

/// The result of eliminating a link: `no_inertia` if the joint leaves a motion free in which the body has no
/// inertia, `dependent_rows` if orientation rows of a point joint depend on each other.
enum class Elimination { done, no_inertia, dependent_rows };

/// Sizes of the columns of a closing, row by row, as if no terms cancelled on the way from body to body. They
/// show whether a column has cancelled and consists of rounding error, which its current value does not show.
template <class S>
struct ColumnSizes {
  Vector6<S> r, x;     ///< the largest squared norms of the column's two parts on the bodies so far
  Vector6<S> product;  ///< size of the diagonal of the closing's block, its terms added by magnitude

  void setZero() {
    r.setZero();
    x.setZero();
    product.setZero();
  }
  void take(int k, const S& r_squared, const S& x_squared) {
    // Faster than `larger`, which keeps a NaN. A NaN need not be kept here: if a part is NaN, so is the pivot
    // that is compared with these sizes.
    r[k] = select(r[k] > r_squared, r[k], r_squared);
    x[k] = select(x[k] > x_squared, x[k], x_squared);
  }
};

/// The wrenches of a closing's rows at an eliminated link, per unit multiplier. `g` has a row per row of the
/// closing: the generalised force along the link's free motion, padded with zeros. `rest_r` and `rest_x` have
/// a column per row: the force and the moment that remain after this motion is eliminated and that the joint
/// carries. For a PointLink the moment is given along its m orientation rows, in the first m places.
template <class S>
struct LinkColumn {
  Matrix6<S> g = Matrix6<S>::Zero();
  PaddedColumns<S, 6> rest_r, rest_x;
};

}  // namespace trivium
