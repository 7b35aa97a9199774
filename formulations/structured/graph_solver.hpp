#pragma once
/// Factorisation and solution of [H Phi^T; Phi 0] along the graph of bodies and joints. One block operation
/// is done per entry of the elimination plan, without allocation and without search. Cost and memory are
/// linear in the number of bodies for trees and for mechanisms with short loops.
///
/// A point joint holds a point by three rows and has up to three orientation rows, which depend on
/// orientations only (body_joint_graph.hpp). All other joints are general. The tree is the spanning tree of
/// the plan.
///
/// A row whose pivot is small is a candidate and is left out: its multiplier is 0 and its right side is
/// ignored. A candidate that turns out to be independent is put back; the other candidates are dependent.
/// DependentRows (graph_system.hpp) selects how this is decided.
///
/// Parts: elimination_impl.hpp (the pass along the plan), point_link.hpp and general_link.hpp (one link),
/// closing_elimination_impl.hpp (one closing), correction_impl.hpp (iterative refinement) and
/// dependent_rows_impl.hpp (candidates that are independent).

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

/// A link cannot be eliminated. Either its joint leaves a motion free in which the body, with the bodies that
/// it carries, has no inertia, or orientation rows of its point joint depend on each other. The whole system
/// may still be regular.
class SingularLink : public ModelError {
 public:
  SingularLink(int body, const std::string& why) : ModelError(why), body_(body) {}
  int body() const { return body_; }  ///< index of the body

 private:
  int body_;
};

/// Row k (0 to 5) of an edge of the graph.
struct EdgeRow {
  int edge, k;
};

/// More than GraphSolver::most_restored candidates are independent.
class NearlyDependentRows : public ModelError {
 public:
  explicit NearlyDependentRows(const EdgeRow& first)
      : ModelError("too many rows are nearly dependent on others"), first_too_many(first) {}
  const EdgeRow first_too_many;
};

/// Factors and solver of one graph. One object serves many matrices, one after the other.
template <class S>
class GraphSolver {
 public:
  explicit GraphSolver(EliminationPlan plan);
  GraphSolver(const GraphSolver&) = delete;
  ~GraphSolver();

  const EliminationPlan& plan() const { return plan_; }

  /// Number of calls of eliminate() for one matrix.
  int steps() const { return static_cast<int>(plan_.steps.size()); }

  /// Factors the matrix, which must outlive the factors. With DependentRows::detect it calls
  /// restore_independent_rows() if a candidate may be independent. A candidate of a
  /// closing may be independent if its pivot exceeds rounding. A candidate of a general joint of the tree
  /// may always be independent, since it can still constrain the parent. Throws SingularLink and
  /// NearlyDependentRows.
  void factor(const GraphMatrix<S>& matrix);

  /// Solves for a right side. Dependent rows have the multiplier 0, and their right sides are ignored.
  void solve(const GraphVector<S>& right_side, GraphVector<S>& solution);

  // start(), eliminate() for each step in order, and substitute() together factor and solve in one pass. They
  // do not put candidates back. The caller may assemble the rows of a link just before its step. Each step
  // has to wait for the results of the step before, and the processor does the assembly during this wait.
  void start(const GraphMatrix<S>& matrix, const GraphVector<S>& right_side);
  /// Throws SingularLink.
  void eliminate(int step, const GraphVector<S>& right_side);
  void substitute(GraphVector<S>& solution);

  /// Sets how the factorisations from now on decide which rows are dependent.
  void set_dependent_rows(DependentRows how) {
    const auto keeps = [](DependentRows decision) {
      return decision == DependentRows::keep || decision == DependentRows::keep_count;
    };
    if (keeps(how) && !keeps(how_)) is_marked_ = is_dependent_;
    if (how != DependentRows::keep)
      kept_borders_.clear();
    else if (!keeps(how_))
      keep_borders_of(*this);
    if (how == DependentRows::detect_near_singular)
      for (auto& rows : is_marked_) rows.fill(false);
    near_singular_pivot_ = trivium::near_singular_pivot<S>();
    how_ = how;
  }
  /// Under DependentRows::detect_near_singular: rows of closings are dependent if their relative pivot is at
  /// most this, until the next set_dependent_rows().
  void leave_out_below(const S& pivot) { near_singular_pivot_ = pivot; }
  /// The least relative pivot of a closing's independent row in the last factorisation under
  /// detect_near_singular; 1 if there are none.
  const S& weakest_pivot() const { return weakest_pivot_; }
  /// Under DependentRows::detect_near_singular: row k of an edge is dependent, whatever its pivot is.
  void mark_dependent(int edge, int k) { is_marked_[edge][k] = true; }

  /// From now on every factorisation keeps the dependent and the bordered rows of the last factorisation of
  /// `other`, and leaves out rows whose pivot is rounding besides. The edges that both graphs have must come
  /// first in both. The dependent rows of further edges do not change.
  void keep_dependent_rows_of(const GraphSolver& other) {
    how_ = DependentRows::keep;
    std::copy_n(other.is_dependent_.begin(), std::min(is_marked_.size(), other.is_dependent_.size()),
                is_marked_.begin());
    keep_borders_of(other);
  }
  /// Under DependentRows::keep, after start() and eliminate(): borders the rows again that the last decision
  /// put back. Returns whether there are any; solve() then gives the solution that satisfies them.
  bool restore_kept_rows() {
    for (const EdgeRow& row : kept_borders_) border(row);
    return !kept_borders_.empty();
  }

  /// Whether row k of an edge is dependent in the last factorisation.
  bool is_dependent(int edge, int k) const { return is_dependent_[edge][k]; }
  /// Number of dependent rows in the last factorisation.
  int dependent_row_count() const {
    int count = 0;
    for (std::size_t e = 0; e < is_dependent_.size(); ++e)
      count += static_cast<int>(
          std::count(is_dependent_[e].begin(), is_dependent_[e].begin() + plan_.graph.edges[e].size(), true));
    return count;
  }
  /// Whether any row of the edge is dependent in the last factorisation.
  bool has_dependent_rows(int edge) const {
    const auto& rows = is_dependent_[edge];
    return std::find(rows.begin(), rows.end(), true) != rows.end();
  }
  /// Puts the candidates back that are independent. Returns whether there are any. A pivot is the square of a
  /// sine and loses the digits of a small sine in rounding, so the elimination leaves out all rows of small
  /// sine. Here these candidates are examined by their sines. A bisection discards sets of rows that depend
  /// on the others, and the sine of each remaining row is computed. The angle is the one between the row's
  /// gradient and the span of all other rows, with rotations converted to lengths by lever2(). If the sine
  /// exceeds direction_tolerance, the row is bordered to the factors: the factored system gets one more row
  /// and column. Throws NearlyDependentRows beyond most_restored.
  ///
  /// Cost: one factorisation and a few solutions, and for each row put back a number of solutions that grows
  /// with the logarithm of the number of candidates. Memory is allocated at the first call and when more rows
  /// are put back than ever before.
  bool restore_independent_rows();
  /// Computes lever2() for the matrix of the last factorisation, at the cost of about one factorisation.
  void measure_levers();
  /// The number of rows that are dependent or weak (weak_pivot) if every body has unit inertia, for the
  /// matrix of the last factorisation. If there are fewer than dependent_row_count(), pivots are small
  /// because bodies are light, not because rows are dependent. Cost: about two factorisations.
  int weak_rows_by_geometry();
  /// Square of the lever [m^2], the length by which rotations of this body are converted to translations,
  /// from the last measure_levers() or restore_independent_rows().
  S lever2(int body) const;
  /// Whether the last factorisation has dependent rows whose pivot exceeds its rounding error.
  bool has_nearly_dependent_rows() const { return has_nearly_dependent_rows_; }
  /// Each row put back stores a response of the size of the whole system and makes every solution slower.
  /// More than 100 come from positions that violate their constraints: redundant rows then look independent.
  static constexpr int most_restored = 100;
  /// Adds multiplier * Phi_k^T of a row to the forces on its two bodies. Not for point joints of the tree.
  void add_row(const EdgeRow& row, const S& multiplier, GraphVector<S>& force) const;

  /// One step of iterative refinement: solves for the `correction` of `solution`, which is not added to it.
  /// `residual` is storage for the residual of the system and may be the same object as `correction`.
  void correct(const GraphMatrix<S>& matrix, const GraphVector<S>& right_side, const GraphVector<S>& solution,
               GraphVector<S>& residual, GraphVector<S>& correction);

 private:
  static constexpr int general = 4;

  /// Forms the residual of a body's equations and of the rows of the joint to its parent, and subtracts this
  /// joint's forces from the residuals of both bodies.
  void link_residual(const GraphMatrix<S>& matrix, int index, const GraphVector<S>& right_side,
                     const GraphVector<S>& solution, GraphVector<S>& residual);
  void edge_residual(const GraphMatrix<S>& matrix, int e, const GraphVector<S>& right_side,
                     const GraphVector<S>& solution, GraphVector<S>& residual) const;

  struct Place {
    int kind;          ///< number of orientation rows of a point link, or `general`
    int index;         ///< index among the links of this kind
    int first_column;  ///< index of the link's first column in link_column_
    int rows;
  };
  /// A row that was put back, bordered to the factors. Its response is the motion a, with its multipliers,
  /// that a unit force along the row causes if all other forces and all right sides of rows are 0. The motion
  /// satisfies the rows in the factors and the rows of earlier borders. The multiplier of the bordered row
  /// itself is -1 in the response.
  struct Border {
    EdgeRow row;
    S mobility;  ///< Phi_k a, the acceleration along the row under its unit force; equal to a^T H a
    GraphVector<S> response;
    S gamma;  ///< the row's right side in the current solution
  };
  /// A test of rows: forces along the rows, the motion that these forces cause, and the correction of this
  /// motion by refinement.
  struct Probe {
    GraphVector<S> load, response, rest;
  };
  class UnitInertiaSolver;
  struct ClosingFactor {
    int rows;
    Matrix6<S> L;         ///< unit lower triangular factor of the block; 0 in the columns of dependent rows
    Vector6<S> inverse;   ///< inverses of the pivots; 0 for dependent rows
    BodyColumns<S> C;     ///< the columns (L^-1 C^T)^T on the body where the closing is eliminated
    Vector6<S> own;       ///< diagonal of the block as the links give it, before other closings change it
    ColumnSizes<S> size;  ///< sizes of the terms of `own` without cancellation
    Vector6<S> gamma;     ///< right side of the closing in the current solution
  };

  template <class Visit>
  void with_link(const Place& place, const Visit& visit);
  LinkRows<S> rows_of(int index) const;
  int rows_of_closing(int c) const { return closing_[c].rows; }
  bool has_parent(const EliminationPlan::Link& link) const { return link.parent != plan_.graph.bodies; }

  /// Factors without putting candidates back.
  void factor_once(const GraphMatrix<S>& matrix);
  void start_factors(const GraphMatrix<S>& matrix);
  void start_solution(const GraphVector<S>& right_side);
  void factor_step(const EliminationPlan::Step& step);
  void forward_step(const EliminationPlan::Step& step, const GraphVector<S>& right_side);

  void factor_link(int index);
  /// Eliminates a closing. Its diagonal block is positive semidefinite and is factored as L D L^T, row by
  /// row. A row whose gradient is a combination of those of the rows before it has pivot 0 and is dependent.
  /// `body` is the block of the body where the closing is eliminated; null at the ground.
  void factor_closing(int c, BodyBlock<S>* body);
  /// Decides, before a closing is eliminated, which of its rows are dependent, and marks them. The
  /// independent rows are chosen by diagonal pivoting: the next one is the row with the largest pivot
  /// relative to its terms. Rows that are chosen in this way determine the motion well, also at later states.
  void choose_rows(int c);
  void forward_link(int index, const GraphVector<S>& right_side);
  /// Eliminates the link's unknowns from the right side. `force` is the body's force plus the forces that its
  /// children passed up. The remainder is added to the parent's force and to the right sides of the closings.
  void pass_up(int index, const BodyPart<S>& force, const GraphVector<S>& right_side, BodyPart<S>* parent);
  void forward_closing(int c, BodyPart<S>* body);
  void backward_closing(int c, GraphVector<S>& solution);
  void backward_link(int index, GraphVector<S>& solution);

  /// Back substitution. Then the responses of the bordered rows are added such that these rows are satisfied.
  void finish(const GraphVector<S>& right_side, GraphVector<S>& solution);
  /// Borders a dependent row to the factors. Returns false if the response to the row is rounding error.
  bool border(const EdgeRow& row);
  /// Leaves the rows that are bordered in `other` out of the elimination, and keeps them to be bordered
  /// again. The elimination could not tell their pivots, the squares of small sines, from rounding errors.
  void keep_borders_of(const GraphSolver& other) {
    kept_borders_.clear();
    for (int n = 0; n < other.bordered_; ++n) {
      const EdgeRow& row = other.borders_[n].row;
      if (plan_.rows_slot[row.edge] < 0) continue;  // a point joint of this tree needs no border
      kept_borders_.push_back(row);
      is_marked_[row.edge][row.k] = true;
    }
  }
  Probe& cleared_probe();
  void refine(Probe& probe);
  /// Phi_k^T of a row on the bodies i and j of its edge; zero on the ground.
  std::array<BodyPart<S>, 2> on_bodies(const EdgeRow& row) const;
  /// a^T H a.
  S energy(const GraphVector<S>& a) const;
  [[noreturn]] static void throw_singular(const EliminationPlan::Link& link, Elimination result);

  const S dependent_pivot_;  ///< see rank_tolerance.hpp
  S near_singular_pivot_, weakest_pivot_{1};
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
  std::vector<std::array<bool, 6>> is_dependent_, is_marked_;  ///< marked: dependent, whatever the pivot is
  DependentRows how_ = DependentRows::detect;
  // rows put back
  std::vector<Border> borders_;  ///< storage; the first bordered_ of them are in use
  int bordered_ = 0;
  std::vector<EdgeRow> kept_borders_;  ///< bordered again after every factorisation under DependentRows::keep
  std::vector<EdgeRow> candidates_;
  // allocated when first needed
  std::optional<Probe> probe_;
  std::shared_ptr<UnitInertiaSolver> unit_inertia_solver_;
  BodyColumns<S> no_columns_;
  // A body without a joint to a parent has no rows. none_ is then read in place of their right side, and
  // nowhere_ is written in place of their multipliers.
  const Vector6<S> none_ = Vector6<S>::Zero();
  Vector6<S> nowhere_;
  const GraphMatrix<S>* matrix_ = nullptr;
};

// expensive to compile, hence compiled once; for another Scalar include graph_solver_impl.hpp
extern template class GraphSolver<double>;

}  // namespace trivium
