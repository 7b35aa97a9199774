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
  GraphSolver(const GraphSolver&) = delete;
  ~GraphSolver();

  const EliminationPlan& plan() const { return plan_; }

  int steps() const { return static_cast<int>(plan_.steps.size()); }

  /// Dependent rows are asked one by one, and restored where they are independent after all, where more than
  /// rounding is left of some, or a joint of the tree has any.
  /// Throws SingularLink and NearlyDependentRows.
  void factor(const GraphMatrix<S>& matrix);

  /// The solution for a right side. Dependent rows have multiplier 0; what their right sides say is not
  /// asked.
  void solve(const GraphVector<S>& right_side, GraphVector<S>& solution);

  // factor and solve at once: start, every step in turn, substitute. Before its step, a link's own rows may
  // still be changed: work on them then hides behind the chain of results from link to link, which is what
  // bounds both
  void start(const GraphMatrix<S>& matrix, const GraphVector<S>& right_side);
  /// Throws SingularLink.
  void eliminate(int step, const GraphVector<S>& right_side);
  void substitute(GraphVector<S>& solution);

  /// How the factorisations that follow decide which rows are dependent.
  void set_dependent_rows(DependentRows how) {
    const auto keeps = [](DependentRows decision) {
      return decision == DependentRows::keep || decision == DependentRows::keep_count;
    };
    if (keeps(how) && !keeps(how_)) is_marked_ = is_dependent_;
    if (how == DependentRows::detect_near_singular)
      for (auto& rows : is_marked_) rows.fill(false);
    how_ = how;
  }
  /// Under DependentRows::detect_near_singular: row k of an edge is dependent, whatever the elimination sees.
  void mark_dependent(int edge, int k) { is_marked_[edge][k] = true; }

  /// In the factorisations that follow the same rows are dependent as in another solver's last one, of the
  /// edges that both have.
  void keep_dependent_rows_of(const GraphSolver& other) {
    how_ = DependentRows::keep;
    std::copy_n(other.is_dependent_.begin(), std::min(is_marked_.size(), other.is_dependent_.size()),
                is_marked_.begin());
  }

  /// Whether row k of an edge is dependent in the last factorisation.
  bool is_dependent(int edge, int k) const { return is_dependent_[edge][k]; }
  /// How many rows are.
  int dependent_row_count() const {
    int count = 0;
    for (std::size_t e = 0; e < is_dependent_.size(); ++e)
      count += static_cast<int>(
          std::count(is_dependent_[e].begin(), is_dependent_[e].begin() + plan_.graph.edges[e].size(), true));
    return count;
  }
  /// Whether any row of the edge is.
  bool has_dependent_rows(int edge) const {
    const auto& rows = is_dependent_[edge];
    return std::find(rows.begin(), rows.end(), true) != rows.end();
  }
  /// The elimination sees squares of sines between rows, and every row that may depend on others to rounding
  /// is dependent at first. Here those of which more than direction_tolerance is left beside the others, in
  /// shifts and turns, are found and bordered to the factors: they count from then on. Returns whether there
  /// are any. Costs as much as the factors and a solution where there is none, and some solutions more times
  /// the logarithm of the dependent rows for each; room is allocated at the first call and where they are
  /// more than ever before. Throws NearlyDependentRows beyond most_restored.
  bool restore_independent_rows();
  /// The square of the lever by which turns of a body compare with shifts, of the matrix that levers were
  /// measured of last. To measure costs as much as factors do.
  void measure_levers();
  S lever2(int body) const;
  /// Whether rows are dependent of which, as far as the elimination sees it, more than rounding is left.
  bool has_nearly_dependent_rows() const { return has_nearly_dependent_rows_; }
  static constexpr int most_restored = 100;
  /// Adds what this multiplier of a row does to its bodies; of an edge that is no point joint of the tree.
  void add_row(const EdgeRow& row, const S& multiplier, GraphVector<S>& force) const;

  /// One step of iterative refinement: what `solution` still needs, into `correction`. What it leaves of the
  /// right side is formed in `residual` link by link, just before it is passed on; the two may be one object.
  void correct(const GraphMatrix<S>& matrix, const GraphVector<S>& right_side, const GraphVector<S>& solution,
               GraphVector<S>& residual, GraphVector<S>& correction);

 private:
  static constexpr int general = 4;

  /// Of a body, and of the joint to its parent: on both bodies, and its rows.
  void link_residual(const GraphMatrix<S>& matrix, int index, const GraphVector<S>& right_side,
                     const GraphVector<S>& solution, GraphVector<S>& residual);
  void edge_residual(const GraphMatrix<S>& matrix, int e, const GraphVector<S>& right_side,
                     const GraphVector<S>& solution, GraphVector<S>& residual) const;

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
  class UnitInertiaSolver;
  struct ClosingFactor {
    int rows;
    Matrix6<S> L;         ///< unit lower triangle of its pivoted block; columns of dependent rows are zero
    Vector6<S> inverse;   ///< of the pivots; 0 for dependent rows
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

  /// As far as the elimination sees which rows are dependent.
  void factor_once(const GraphMatrix<S>& matrix);
  void start_factors(const GraphMatrix<S>& matrix);
  void start_solution(const GraphVector<S>& right_side);
  void factor_step(const EliminationPlan::Step& step);
  void forward_step(const EliminationPlan::Step& step, const GraphVector<S>& right_side);

  void factor_link(int index);
  /// The closing's block is positive semidefinite: rows in their order, dependent where they depend on the
  /// ones before them.
  void factor_closing(int c, BodyBlock<S>* body);
  /// Takes the rows of most effect first, so that the dependent ones depend on rows that determine their
  /// motion well, wherever a motion goes.
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

  const S dependent_pivot_, near_singular_pivot_;  ///< see rank_tolerance.hpp
  bool has_nearly_dependent_rows_ = false;

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
  std::vector<std::array<bool, 6>> is_dependent_, is_marked_;  ///< marked: dependent, whatever is seen
  DependentRows how_ = DependentRows::detect;
  // rows told apart
  std::vector<Border> borders_;  ///< the first `bordered_`
  int bordered_ = 0;
  std::vector<EdgeRow> candidates_;
  // made when first needed
  std::optional<Probe> probe_;
  std::shared_ptr<UnitInertiaSolver> unit_inertia_solver_;
  BodyColumns<S> no_columns_;
  // the rows of a body that hangs on nothing
  const Vector6<S> none_ = Vector6<S>::Zero();
  Vector6<S> nowhere_;
  const GraphMatrix<S>* matrix_ = nullptr;
};

// dear to compile, so compiled once; for another Scalar include graph_solver_impl.hpp
extern template class GraphSolver<double>;

}  // namespace trivium
