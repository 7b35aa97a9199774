#pragma once
/// [H Phi^T; Phi 0] factored and solved along the body-joint graph: one block operation per entry of the
/// plan, no allocation and no search. Cost and memory are linear in the bodies of a tree, and wherever loops
/// are short.

#include <array>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bodies/error.hpp"
#include "formulations/general_link.hpp"
#include "formulations/graph_system.hpp"
#include "formulations/point_link.hpp"

namespace trivium {

/// A body that cannot be eliminated with its link: the joint to its parent leaves a motion without inertia
/// free, has dependent rows of orientation, or binds the parent's absolute motion. The system may still be
/// regular.
class SingularLink : public ModelError {
 public:
  SingularLink(int body, const std::string& why) : ModelError(why), body_(body) {}
  int body() const { return body_; }

 private:
  int body_;
};

template <class S>
class GraphSolver {
 public:
  explicit GraphSolver(EliminationPlan plan);

  const EliminationPlan& plan() const { return plan_; }

  int steps() const { return static_cast<int>(plan_.steps.size()); }

  /// Throws SingularLink.
  void factor(const GraphMatrix<S>& matrix);

  /// The solution for a right side. Rows that depend on others have multiplier 0; what their right sides say
  /// is not asked.
  void solve(const GraphVector<S>& right_side, GraphVector<S>& solution);

  // factor and solve at once: start, every step in turn, substitute. Before its step, a link's own rows may
  // still be changed: work on them then hides behind the chain of results from link to link, which is what
  // bounds both
  void start(const GraphMatrix<S>& matrix, const GraphVector<S>& right_side);
  /// Throws SingularLink.
  void eliminate(int step, const GraphVector<S>& right_side);
  void substitute(GraphVector<S>& solution);

  /// Whether row k of an edge was left out because it depends on others.
  bool is_dropped(int edge, int k) const { return dropped_[edge][k]; }
  /// A row of a loop is left out where the square of its sine to the others, in the metric of H, is at most
  /// this.
  static S dependence() { return larger(S(1000 * unit_roundoff<S>()), S(1e-16)); }

  /// One step of iterative refinement: what `solution` still needs, into `correction`. What it leaves of the
  /// right side is formed in `defect` link by link, just before it is passed on; the two may be one object.
  void correct(const GraphMatrix<S>& matrix, const GraphVector<S>& right_side, const GraphVector<S>& solution,
               GraphVector<S>& defect, GraphVector<S>& correction);

 private:
  static constexpr int general = 4;

  /// Of a body, and of the joint to its parent: on both bodies, and its rows.
  void link_defect(const GraphMatrix<S>& matrix, int index, const GraphVector<S>& right_side,
                   const GraphVector<S>& solution, GraphVector<S>& defect) const;
  void edge_defect(const GraphMatrix<S>& matrix, int e, const GraphVector<S>& right_side,
                   const GraphVector<S>& solution, GraphVector<S>& defect) const;

  struct Place {
    int kind;          ///< rows of orientation of a point link, or `general`
    int index;         ///< among the links of its kind
    int first_column;  ///< in link_column_
    int rows;
  };
  struct ClosingFactor {
    Matrix6<S> L;         ///< unit lower triangle of its pivoted block; columns of dropped rows are zero
    Vector6<S> inverse;   ///< of the pivots; 0 for dropped rows
    BodyColumns<S> C;     ///< of L^-1 C^T, on the body where it is eliminated
    Vector6<S> own;       ///< the diagonal before other closings go
    ColumnSizes<S> size;  ///< of what that was made of
    Vector6<S> gamma;     ///< the right side at hand
  };

  template <class Visit>
  void with_link(const Place& place, const Visit& visit);
  LinkRows<S> rows_of(int index) const;
  int rows_of_closing(int c) const { return plan_.graph.edges[plan_.closings[c].edge].size(); }
  bool has_parent(const EliminationPlan::Link& link) const { return link.parent != plan_.graph.bodies; }

  void start_factors(const GraphMatrix<S>& matrix);
  void start_solution(const GraphVector<S>& right_side);
  void factor_step(const EliminationPlan::Step& step);
  void forward_step(const EliminationPlan::Step& step, const GraphVector<S>& right_side);

  void factor_link(int index);
  /// The closing's block is positive semidefinite: rows in their order, those that depend on the ones before
  /// them left out.
  void factor_closing(int c);
  void forward_link(int index, const GraphVector<S>& right_side);
  /// The right side of a link, its body's forces with what its children passed up: to its parent, and to the
  /// closings.
  void pass_up(int index, const BodyPart<S>& force, const GraphVector<S>& right_side, BodyPart<S>* parent);
  void forward_closing(int c, std::vector<BodyPart<S>>& carried);
  void backward_closing(int c, GraphVector<S>& solution);
  void backward_link(int index, GraphVector<S>& solution);
  [[noreturn]] static void throw_singular(const EliminationPlan::Link& link, Elimination result);

  EliminationPlan plan_;
  std::vector<Place> place_;
  std::tuple<std::vector<PointLink<S, 0>>, std::vector<PointLink<S, 1>>, std::vector<PointLink<S, 2>>,
             std::vector<PointLink<S, 3>>, std::vector<GeneralLink<S>>>
      links_;
  std::vector<BodyBlock<S>> block_;
  std::vector<BodyColumns<S>> column_;
  std::vector<Matrix6<S>> coupling_;
  std::vector<LinkColumn<S>> link_column_;
  std::vector<ClosingFactor> closing_;
  std::vector<BodyPart<S>> carried_;
  std::vector<std::array<bool, 6>> dropped_;
  BodyColumns<S> no_columns_;
  // the rows of a body that hangs on nothing
  const Vector6<S> none_ = Vector6<S>::Zero();
  Vector6<S> nowhere_;
  const GraphMatrix<S>* matrix_ = nullptr;
};

// dear to compile, so compiled once; for another Scalar include graph_solver_impl.hpp
extern template class GraphSolver<float>;
extern template class GraphSolver<double>;
extern template class GraphSolver<Quad>;

}  // namespace trivium
