#pragma once
/// GraphSolver: decides by geometry alone which rows are independent. It solves the same system with the
/// mass 1 and the moments of inertia l^2 for every body, where l is a mean lever. If positions are inexact, a
/// dependent row differs a little from the combination of other rows that it should be, and a small inertia
/// in some direction would magnify this difference. A part of dependent_rows_impl.hpp.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "bodies/numbers/scalar.hpp"
#include "formulations/structured/connected_bodies.hpp"
#include "formulations/structured/graph_solver.hpp"

namespace trivium {

/// The system with the same rows and H = diag(1, 1, 1, l^2, l^2, l^2) for each body. The lever l converts
/// rotations to lengths. l^2 is a mean over all bodies of the same component (connected_bodies.hpp): the mean
/// of |x|^2 / |r|^2 over their rows with a translational part r. l is 1 where there is no lever. The three
/// rows of a point joint of the tree count as one.
template <class S>
class GraphSolver<S>::UnitInertiaSolver {
 public:
  explicit UnitInertiaSolver(const EliminationPlan& plan)
      : matrix_(plan),
        solver_(plan),
        component_(components_of(plan.graph)),
        lever2_(plan.graph.bodies),
        holding_(lever2_) {}

  void factor(const GraphMatrix<S>& matrix) {
    matrix_.point = matrix.point;
    matrix_.rows = matrix.rows;
    measure_levers();
    for (std::size_t b = 0; b < matrix_.H.size(); ++b)
      for (int m = 0; m < 3; ++m) {
        matrix_.H[b].rr(m, m) = S(1);
        matrix_.H[b].xx(m, m) = lever2(static_cast<int>(b));
      }
    solver_.factor_once(matrix_);
  }

  /// The given rows that are independent: the sine between the row and the span of all other rows exceeds
  /// direction_tolerance. Such a row is bordered here, and the rows after it are tested against this row too.
  const std::vector<EdgeRow>& independent(const std::vector<EdgeRow>& rows) {
    candidates_.clear();
    independent_.clear();
    for (const EdgeRow& row : rows)
      (solver_.is_dependent(row.edge, row.k) ? candidates_ : independent_).push_back(row);
    if (!candidates_.empty()) search(candidates_);
    return independent_;
  }
  /// The number of dependent rows and of rows with weak pivots (weak_pivot), for the matrix of the last
  /// factor().
  int weak_rows() {
    solver_.set_dependent_rows(DependentRows::detect_near_singular);
    solver_.leave_out_below(S(weak_pivot));
    solver_.factor_once(matrix_);
    const int count = solver_.dependent_row_count();
    solver_.set_dependent_rows(DependentRows::detect);
    return count;
  }
  const S& lever2(int body) const { return lever2_[component_[body]]; }

 private:
  /// Bisection. If random combinations of a set of rows depend on the other rows, the set is discarded.
  /// Otherwise each half is searched.
  void search(std::span<const EdgeRow> rows) {
    if (rows.size() == 1) {
      if (left_of(rows, 0) > square(tolerance()) && solver_.border(rows.front()))
        independent_.push_back(rows.front());
      return;
    }
    // The remainders of rows may cancel by accident in a combination. So two combinations are tried, against
    // a tolerance that is smaller by the factor 30: that both cancel so far has a probability of about 1e-3.
    // A larger factor leaves more sets to halve, a smaller one discards more independent rows by accident.
    const S little = square(tolerance() / 30);
    if (all(left_of(rows, 1) <= little) && all(left_of(rows, 2) <= little)) return;
    search(rows.first(rows.size() / 2));
    search(rows.subspan(rows.size() / 2));
  }

  /// Square of the remainder of a combination of the rows. The remainder is the part outside the span of all
  /// other rows. Each row is scaled to unit size and has a random coefficient of magnitude 0.5 to 1. A single
  /// row has the coefficient 1, and the result is the square of its sine.
  S left_of(std::span<const EdgeRow> rows, std::uint32_t seed) {
    using std::sqrt;
    Probe& probe = solver_.cleared_probe();
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(-0.5, 0.5);
    for (const EdgeRow& row : rows) {
      const double part = share(random);
      const S size = size_of(row), weight = S(rows.size() == 1 ? 1 : part < 0 ? part - 0.5 : part + 0.5);
      solver_.add_row(row, select(size > S(0), S(weight / sqrt(size)), S(0)), probe.load);
    }
    solver_.solve(probe.load, probe.response);
    const S rough = solver_.energy(probe.response);
    // Below the smallest limit of search() the rows are dependent, and a refined remainder, which is smaller
    // still, would not change this.
    if (all(rough <= square(tolerance() / 30))) return rough;
    solver_.refine(probe);
    return solver_.energy(probe.response);
  }
  static S square(const S& x) { return x * x; }
  S tolerance() const { return direction_tolerance<S>(solver_.plan_.graph.rank_tolerance); }

  /// Square of the row's norm in the metric of H^-1.
  S size_of(const EdgeRow& row) const {
    const GraphEdge& edge = solver_.plan_.graph.edges[row.edge];
    const auto [on_i, on_j] = solver_.on_bodies(row);
    const auto size_on = [&](int body, const BodyPart<S>& on) {
      if (body == solver_.plan_.graph.bodies) return S(0);
      return S(on.r.squaredNorm() + on.x.squaredNorm() / lever2(body));
    };
    return size_on(edge.i, on_i) + size_on(edge.j, on_j);
  }

  /// Computes l^2 of every component.
  void measure_levers() {
    const EliminationPlan& plan = solver_.plan_;
    std::fill(lever2_.begin(), lever2_.end(), S(0));
    std::fill(holding_.begin(), holding_.end(), S(0));
    const auto take = [&](int body, const S& r2, const S& x2) {
      if (body == plan.graph.bodies) return;
      lever2_[component_[body]] += select(r2 > S(0), S(x2 / r2), S(0));
      holding_[component_[body]] += select(r2 > S(0), S(1), S(0));
    };
    for (std::size_t n = 0; n < plan.links.size(); ++n) {
      if (!plan.is_point_link(plan.links[n])) continue;
      take(plan.links[n].body, S(3), matrix_.point[n].L_child.squaredNorm());
      take(plan.links[n].parent, S(3), matrix_.point[n].L_parent.squaredNorm());
    }
    for (std::size_t e = 0; e < plan.graph.edges.size(); ++e) {
      if (plan.rows_slot[e] < 0) continue;
      const GraphEdge& edge = plan.graph.edges[e];
      const EdgeRows<S>& columns = matrix_.rows[plan.rows_slot[e]];
      for (int k = 0; k < edge.size(); ++k) {
        take(edge.i, columns.C_i.r.col(k).squaredNorm(), columns.C_i.x.col(k).squaredNorm());
        take(edge.j, columns.C_j.r.col(k).squaredNorm(), columns.C_j.x.col(k).squaredNorm());
      }
    }
    for (std::size_t a = 0; a < lever2_.size(); ++a)
      lever2_[a] = select(lever2_[a] > S(0), S(lever2_[a] / holding_[a]), S(1));
  }

  GraphMatrix<S> matrix_;
  GraphSolver solver_;
  std::vector<int> component_;       ///< by body: the body that stands for its component
  std::vector<S> lever2_, holding_;  ///< by component: l^2, and the number of levers in this mean
  std::vector<EdgeRow> candidates_, independent_;
};

}  // namespace trivium
