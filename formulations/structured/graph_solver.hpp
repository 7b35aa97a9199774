#pragma once
/// [H Phi^T; Phi 0] factored and solved along the body-joint graph: one block operation per entry of the
/// plan, no allocation and no search. Cost and memory are linear in the bodies of a tree, and wherever loops
/// are short.

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "formulations/structured/general_link.hpp"
#include "formulations/structured/graph_system.hpp"
#include "formulations/structured/point_link.hpp"

namespace trivium {

/// A body that cannot be eliminated with its link: the joint to its parent leaves a motion without inertia
/// free, or has dependent rows of orientation. The system may still be regular.
class SingularLink : public ModelError {
 public:
  SingularLink(int body, const std::string& why) : ModelError(why), body_(body) {}
  int body() const { return body_; }

 private:
  int body_;
};

/// Row k of an edge.
struct EdgeRow {
  int edge, k;
};

/// More rows than can be told apart one by one depend on others nearly, but not quite.
class NearlyDependentRows : public ModelError {
 public:
  explicit NearlyDependentRows(const EdgeRow& first)
      : ModelError("too many rows depend on others nearly, but not quite"), first_too_many(first) {}
  const EdgeRow first_too_many;
};

template <class S>
class GraphSolver {
 public:
  explicit GraphSolver(EliminationPlan plan);
  ~GraphSolver();

  const EliminationPlan& plan() const { return plan_; }

  int steps() const { return static_cast<int>(plan_.steps.size()); }

  /// Rows left out are reinstated where more than rounding is left of some, or a joint of the tree has any.
  /// Throws SingularLink and NearlyDependentRows.
  void factor(const GraphMatrix<S>& matrix);

  /// The solution for a right side. Rows that were left out have multiplier 0; what their right sides say is
  /// not asked.
  void solve(const GraphVector<S>& right_side, GraphVector<S>& solution);

  // factor and solve at once: start, every step in turn, substitute. Before its step, a link's own rows may
  // still be changed: work on them then hides behind the chain of results from link to link, which is what
  // bounds both
  void start(const GraphMatrix<S>& matrix, const GraphVector<S>& right_side);
  /// Throws SingularLink.
  void eliminate(int step, const GraphVector<S>& right_side);
  void substitute(GraphVector<S>& solution);

  /// How the factorisations that follow find the rows to leave out.
  void find_ranks(Ranks ranks) {
    const auto goes_by_before = [](Ranks r) { return r == Ranks::kept || r == Ranks::counted; };
    if (goes_by_before(ranks) && !goes_by_before(ranks_)) out_ = dropped_;
    if (ranks == Ranks::seen)
      for (auto& rows : out_) rows.fill(false);
    ranks_ = ranks;
  }
  /// Of ranks that are seen: leaves row k of an edge out, whatever the elimination sees of it.
  void leave_out(int edge, int k) { out_[edge][k] = true; }

  /// The factorisations that follow leave out the same rows as another solver's last one, of the edges that
  /// both have.
  void leave_out_as(const GraphSolver& other) {
    ranks_ = Ranks::kept;
    std::copy_n(other.dropped_.begin(), std::min(out_.size(), other.dropped_.size()), out_.begin());
  }

  /// Whether row k of an edge was left out.
  bool is_dropped(int edge, int k) const { return dropped_[edge][k]; }
  /// How many rows were.
  int left_out() const {
    int count = 0;
    for (std::size_t e = 0; e < dropped_.size(); ++e)
      count += static_cast<int>(
          std::count(dropped_[e].begin(), dropped_[e].begin() + plan_.graph.edges[e].size(), true));
    return count;
  }
  /// Whether any row of it was.
  bool leaves_out(int edge) const {
    const auto& rows = dropped_[edge];
    return std::find(rows.begin(), rows.end(), true) != rows.end();
  }
  /// The elimination sees squares of sines between rows, and leaves out every row that may depend on others
  /// to rounding. Here those of which more than direction_tolerance is left beside the others, in shifts and
  /// turns, are found and bordered to the factors: they count from then on. Returns whether there are any.
  /// Costs as much as the factors and a solution where there is none, and some solutions more times the
  /// logarithm of the rows left out for each; room is allocated at the first call and where they are more
  /// than ever before. Throws NearlyDependentRows beyond most_reinstated.
  bool restore_independent_rows();
  /// The square of the lever by which turns of a body compare with shifts: known after
  /// restore_independent_rows where rows were left out.
  S lever2(int body) const;
  /// Whether rows were left out of which, as far as the elimination sees it, more than rounding is left.
  bool has_doubtful_rows() const { return has_thin_rows_; }
  static constexpr int most_reinstated = 100;
  /// Adds what this multiplier of a row does to its bodies; of an edge that is no point joint of the tree.
  void add_row(const EdgeRow& row, const S& multiplier, GraphVector<S>& force) const;

  /// One step of iterative refinement: what `solution` still needs, into `correction`. What it leaves of the
  /// right side is formed in `defect` link by link, just before it is passed on; the two may be one object.
  void correct(const GraphMatrix<S>& matrix, const GraphVector<S>& right_side, const GraphVector<S>& solution,
               GraphVector<S>& defect, GraphVector<S>& correction);

 private:
  static constexpr int general = 4;

  /// Of a body, and of the joint to its parent: on both bodies, and its rows.
  void link_defect(const GraphMatrix<S>& matrix, int index, const GraphVector<S>& right_side,
                   const GraphVector<S>& solution, GraphVector<S>& defect);
  void edge_defect(const GraphMatrix<S>& matrix, int e, const GraphVector<S>& right_side,
                   const GraphVector<S>& solution, GraphVector<S>& defect) const;

  struct Place {
    int kind;          ///< rows of orientation of a point link, or `general`
    int index;         ///< among the links of its kind
    int first_column;  ///< in link_column_
    int rows;
  };
  /// A row bordered to the factors: its response is the solution, by the rows before it, to a force of -1
  /// along it and its own multiplier 1.
  struct Border {
    EdgeRow row;
    S stiffness;  ///< by how much the response moves along the row
    GraphVector<S> response;
    S gamma;  ///< the right side at hand
  };
  /// A force along rows, the response to it, and what a refinement would still change there.
  struct Probe {
    GraphVector<S> load, response, rest;
  };
  class Geometry;
  struct ClosingFactor {
    int rows;
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
  int rows_of_closing(int c) const { return closing_[c].rows; }
  bool has_parent(const EliminationPlan::Link& link) const { return link.parent != plan_.graph.bodies; }

  void start_factors(const GraphMatrix<S>& matrix);
  void start_solution(const GraphVector<S>& right_side);
  void factor_step(const EliminationPlan::Step& step);
  void forward_step(const EliminationPlan::Step& step, const GraphVector<S>& right_side);

  void factor_link(int index);
  /// The closing's block is positive semidefinite: rows in their order, those that depend on the ones before
  /// them left out.
  void factor_closing(int c, BodyBlock<S>* body);
  /// Of ranks that are seen: takes the rows of most effect first, so that those left out depend on rows that
  /// determine their motion well, wherever a motion goes.
  void choose_rows(int c);
  void forward_link(int index, const GraphVector<S>& right_side);
  /// The right side of a link, its body's forces with what its children passed up: to its parent, and to the
  /// closings.
  void pass_up(int index, const BodyPart<S>& force, const GraphVector<S>& right_side, BodyPart<S>* parent);
  void forward_closing(int c, BodyPart<S>* body);
  void backward_closing(int c, GraphVector<S>& solution);
  void backward_link(int index, GraphVector<S>& solution);

  /// Substitutes, and meets the rows that are bordered.
  void finish(const GraphVector<S>& right_side, GraphVector<S>& solution);
  /// False, and nothing done, where what is left of the row is rounding.
  bool border(const EdgeRow& row);
  Probe& cleared_probe();
  void refine(Probe& probe);
  /// A row on its edge's bodies i and j; zero on the ground.
  std::array<BodyPart<S>, 2> on_bodies(const EdgeRow& row) const;
  /// a^T H a.
  S energy(const GraphVector<S>& a) const;
  [[noreturn]] static void throw_singular(const EliminationPlan::Link& link, Elimination result);

  /// The pivot, as a share of what it was before other rows went, up to which a row is left out. Above it one
  /// refinement makes up for the pivot's own rounding; and no row that misplaced points alone make
  /// independent comes near it, unless its motion has next to no inertia.
  const S doubtful_pivot_;
  /// The same for Ranks::seen, and as a share of what it was made of. A motion passes a singular position on
  /// a row whose sine is the root of this, so that what the row then is not asked is its square.
  const S passing_pivot_;
  bool has_thin_rows_ = false;

  EliminationPlan plan_;
  std::vector<Place> place_;
  std::tuple<std::vector<PointLink<S, 0>>, std::vector<PointLink<S, 1>>, std::vector<PointLink<S, 2>>,
             std::vector<PointLink<S, 3>>, std::vector<GeneralLink<S>>>
      links_;
  std::vector<BodyBlock<S>> block_sum_;
  std::vector<BodyColumns<S>> column_;
  std::vector<Matrix6<S>> coupling_;
  std::vector<LinkColumn<S>> link_column_;
  std::vector<ClosingFactor> closing_;
  std::vector<BodyPart<S>> force_sum_;
  std::vector<std::array<bool, 6>> dropped_, out_;
  Ranks ranks_ = Ranks::found;
  // rows told apart
  std::vector<Border> borders_;  ///< the first `bordered_`
  int bordered_ = 0;
  std::vector<EdgeRow> left_out_;
  // made when first needed
  std::optional<Probe> probe_;
  std::unique_ptr<Geometry> geometry_;
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
