#pragma once
/// Accelerations and multipliers of one formulation in O(nb): the augmented system with its normalisation
/// rows eliminated in closed form, assembled joint by joint and solved along the body-joint graph. One object
/// per mechanism, planned once; solving again at another state allocates nothing.

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "formulations/equations_of_motion.hpp"
#include "formulations/graph_solver.hpp"
#include "formulations/point_joint.hpp"

namespace trivium {

/// What one refinement corrected, relative: accelerations in the mass metric; multipliers by the forces and
/// by the moments that they exert, whichever is worse. It is the error of the unrefined solution; what is
/// left is smaller. Where forces in balance leave no acceleration, all of it is correction.
struct Corrections {
  double acceleration = 0, lambda = 0;
};

enum class Refinement { none, once };

template <Formulation F>
class AccelerationSolver {
 public:
  using S = typename F::Scalar;
  using Body = typename F::Reduced;

  /// The mechanism must outlive the solver.
  explicit AccelerationSolver(const Mechanism<S>& mechanism)
      : mechanism_(mechanism),
        solver_(plan_elimination(body_joint_graph(mechanism))),
        matrix_(solver_.plan()),
        right_side_(solver_.plan().graph),
        solution_(right_side_),
        defect_(right_side_),
        step_(right_side_),
        wrenches_(mechanism.nb() + 1),
        motion_(mechanism.nb() + 1) {
    body_.resize(mechanism.nb() + 1);
    body_.back() = Body{body_kinematics(std::vector<BodyState<F>>{}).back()};
    turning_.resize(mechanism.nb() + 1);
    turning_.back() = F::turning(body_.back());
    for (int b = 0; b < mechanism.nb(); ++b) matrix_.H[b].rr.diagonal().setConstant(mechanism.bodies[b].mass);
    plan_assembly();
  }

  /// Solves at a state. Throws a ModelError that names the body where a link is singular, and the row where
  /// redundant rows contradict each other; all answers are NaN then.
  void solve(std::span<const BodyState<F>> state, const S& t, Refinement refinement = Refinement::once) {
    try {
      move_bodies(state, t);
      assemble_closings(t);
      solver_.start(matrix_, right_side_);
      eliminate(t);
      solver_.substitute(solution_);
      if (refinement == Refinement::once) refine();
      check_dropped_rows(t);
    } catch (...) {
      forget();
      throw;
    }
  }

  /// One step of iterative refinement.
  void refine() {
    solver_.correct(matrix_, right_side_, solution_, defect_, step_);
    measure_and_add_step();
  }

  const EliminationPlan& plan() const { return solver_.plan(); }
  /// Of the last refinement.
  const Corrections& corrections() const { return corrections_; }

  Vector3<S> r_ddot(int b) const { return unpadded<S>(solution_.body[b].r); }
  /// The formulation's own unknown.
  typename F::Unknown q_ddot(int b) const {
    return F::from_reduced(body_[b], unpadded<S>(solution_.body[b].x));
  }
  Vector3<S> omega_bar_dot(int b) const { return F::to_angular_acceleration(body_[b], q_ddot(b)); }
  /// One multiplier per row of the mechanism; 0 in rows that were left out because they depend on others.
  VectorX<S> lambda() const {
    VectorX<S> all(mechanism_.nc());
    for_each_row([&](int edge, int k, int row) { all[row] = solution_.edge[edge][k]; });
    return all;
  }
  std::vector<int> dropped_rows() const {
    std::vector<int> rows;
    for_each_row([&](int edge, int k, int row) {
      if (solver_.is_dropped(edge, k)) rows.push_back(row);
    });
    std::sort(rows.begin(), rows.end());
    return rows;
  }
  int rank() const { return mechanism_.nc() - static_cast<int>(dropped_rows().size()); }

  // on demand, one solve per dropped row; not for the timed path

  /// Which multipliers are unique: those that no combination that acts on nothing contains.
  std::vector<bool> unique();
  /// Lambda of minimum |E lambda| among those with the same Phi^T lambda, E = diag(Phi M^-1 Phi^T)^(1/2).
  /// Throws a ModelError that names the body where M is singular and the choice matters.
  VectorX<S> minimum_norm_lambda();

 private:
  /// A point joint of the tree, and one that closes a loop.
  struct LinkJoint {
    int link, edge;
    bool child_is_j;
    PointJoint<S> joint;
  };
  struct ClosingJoint {
    int edge;
    PointJoint<S> joint;
  };

  void plan_assembly() {
    const EliminationPlan& plan = solver_.plan();
    for (std::size_t n = 0; n < plan.links.size(); ++n) {
      const EliminationPlan::Link& link = plan.links[n];
      if (plan.is_point_link(link))
        links_.push_back(
            {static_cast<int>(n), link.edge, link.body_is_j, {mechanism_, plan.graph.edges[link.edge]}});
    }
    for (int e = 0; e < static_cast<int>(plan.graph.edges.size()); ++e) {
      const GraphEdge& edge = plan.graph.edges[e];
      if (plan.rows_slot[e] < 0) continue;
      ranked_.push_back(e);
      if (edge.is_point) {
        closings_.push_back({e, {mechanism_, edge}});
        EdgeRows<S>& rows = matrix_.rows[plan.rows_slot[e]];
        for (int k = 0; k < 3; ++k) {
          rows.C_i.r(k, k) = S(-1);
          rows.C_j.r(k, k) = S(1);
        }
      } else {
        others_.push_back(e);
      }
    }
  }

  /// Link by link, each joint evaluated just before its step.
  void eliminate(const S& t) {
    auto joint = links_.begin();
    try {
      for (int step = 0; step < solver_.steps(); ++step) {
        if (joint != links_.end() && joint->link == solver_.plan().steps[step].link)
          assemble_link(*joint++, t);
        solver_.eliminate(step, right_side_);
      }
    } catch (const SingularLink& e) {
      require_numbers(t);
      throw ModelError(
          fmt::format("body \"{}\" at t = {}: {}; its links cannot be eliminated one by one: solve the "
                      "printed system instead",
                      mechanism_.body_names[e.body()], static_cast<double>(t), e.what()));
    }
  }

  /// Rows that were left out are combinations of the others: their right sides must be the same combinations.
  void check_dropped_rows(const S& t) {
    using std::sqrt;
    if (ranked_.empty()) return;
    const S tolerance = larger(S(1e-6), S(3 * sqrt(solver_.dependence())));
    const S rounding = larger(S(1e-6 * tolerance), S(100 * unit_roundoff<S>()));
    const auto size_here = [&](int b) { return size_of(solution_.body[b]); };
    if (!unmet_row(solution_, rounding, size_here)) return;
    // forces in balance leave accelerations that are rounding, beside what the forces could cause
    Size whole, turning;
    for (int b = 0; b < mechanism_.nb(); ++b)  // with levers, what gamma is made of
      turning.take({S(0), turning_[b].omega.squaredNorm()});
    whole = turning;
    for (int b = 0; b < mechanism_.nb(); ++b) {
      const BodyPart<S>& force = right_side_.body[b];
      const S moments = matrix_.H[b].xx.diagonal().sum();
      const Size of_force = size_of(force);
      whole.take(size_here(b));
      whole.take({of_force.r / mechanism_.bodies[b].mass, moments > S(0) ? S(of_force.x / moments) : S(0)});
    }
    if (const auto row = unmet_row(solution_, tolerance, [&](int) { return whole; })) throw_unmet(*row, t);
    // how much of it is rounding of the forces shows without them
    for (BodyPart<S>& force : right_side_.body) force = {};
    solver_.solve(right_side_, step_);
    solver_.correct(matrix_, right_side_, step_, defect_, defect_);
    whole = turning;
    for (int b = 0; b < mechanism_.nb(); ++b) {
      step_.body[b] += defect_.body[b];
      push_body(b);
      whole.take(size_of(step_.body[b]));
    }
    if (const auto row = unmet_row(step_, tolerance, [&](int) { return whole; })) throw_unmet(*row, t);
  }
  /// The largest number of each part.
  struct Size {
    S r{0}, x{0};
    void take(const Size& other) {
      r = larger(r, other.r);
      x = larger(x, other.x);
    }
  };
  static Size size_of(const BodyPart<S>& part) {
    using std::abs;
    Size size;
    for (int k = 0; k < 3; ++k) size.take({S(abs(part.r[k])), S(abs(part.x[k]))});
    return size;
  }
  struct Row {
    int edge, k;
  };
  /// The first row that was left out and that the solution misses by more than this share of what it is made
  /// of: gamma, and accelerations of a size by body. What velocities of rounding size leave, below 1e-12, is
  /// none.
  template <class SizeOf>
  std::optional<Row> unmet_row(const GraphVector<S>& solution, const S& tolerance,
                               const SizeOf& size_of_body) const {
    using std::abs;
    for (const int e : ranked_) {
      const GraphEdge& edge = solver_.plan().graph.edges[e];
      const EdgeRows<S>& rows = matrix_.rows[solver_.plan().rows_slot[e]];
      for (int k = 0; k < edge.size(); ++k) {
        if (!solver_.is_dropped(e, k)) continue;
        S missing = right_side_.edge[e][k], made_of = abs(missing);
        const auto take = [&](const BodyColumns<S>& C, int b) {
          if (b == mechanism_.ground()) return;
          const BodyPart<S>& a = solution.body[b];
          const Size size = size_of_body(b);
          missing -= C.r.col(k).dot(a.r) + C.x.col(k).dot(a.x);
          made_of += C.r.col(k).cwiseAbs().sum() * size.r + C.x.col(k).cwiseAbs().sum() * size.x;
        };
        take(rows.C_i, edge.i);
        take(rows.C_j, edge.j);
        if (!(abs(missing) <= tolerance * made_of + S(1e-12))) return Row{e, k};
      }
    }
    return {};
  }
  [[noreturn]] void throw_unmet(const Row& row, const S& t) const {
    require_numbers(t);
    const int k = solver_.plan().graph.edges[row.edge].rows[row.k];
    throw ModelError(fmt::format(
        "row \"{}\" at t = {}: it depends on other rows, to the precision of this Scalar, and asks for "
        "another "
        "acceleration than they do. Either none satisfies all: remove a row, or make their functions of time "
        "agree; or the masses lie too far apart to tell: take a wider Scalar, or solve the printed system",
        mechanism_.row_names[k], static_cast<double>(t)));
  }
  /// Throws a ModelError that names the body whose state is not a number.
  void require_numbers(const S& t) const {
    using std::isfinite;
    for (int b = 0; b < mechanism_.nb(); ++b)
      if (!isfinite(
              S(turning_[b].A.sum() + turning_[b].omega.sum() + body_[b].r.sum() + body_[b].r_dot.sum())))
        throw ModelError(fmt::format("body \"{}\" at t = {}: its state is not finite",
                                     mechanism_.body_names[b], static_cast<double>(t)));
  }
  /// No answer of another state may be taken for one of this.
  void forget() {
    const S nothing = std::numeric_limits<S>::quiet_NaN();
    for (BodyPart<S>& part : solution_.body) {
      part.r.setConstant(nothing);
      part.x.setConstant(nothing);
    }
    for (Vector6<S>& lambda : solution_.edge) lambda.setConstant(nothing);
    corrections_ = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  }

  void move_bodies(std::span<const BodyState<F>> state, const S& t) {
    const bool effects_see_motion = mechanism_.effects.see_motion();
    if (!effects_see_motion) apply_effects(t);
    for (int b = 0; b < mechanism_.nb(); ++b) {
      move_body(b, state[b]);
      if (!effects_see_motion) push_body(b);
    }
    if (!effects_see_motion) return;
    std::copy(body_.begin(), body_.end(), motion_.begin());
    apply_effects(t);
    for (int b = 0; b < mechanism_.nb(); ++b) push_body(b);
  }
  [[gnu::flatten]] void move_body(int b, const BodyState<F>& state) {
    body_[b] = Body{F::kinematics(state.chart, state.r, state.r_dot, state.q)};
    turning_[b] = F::turning(body_[b]);
    matrix_.H[b].xx.template topRows<3>() = F::reduced_mass_block(body_[b], mechanism_.bodies[b].inertia);
  }
  [[gnu::flatten]] void push_body(int b) {
    const Wrench<S>& wrench = wrenches_[b];
    const Vector3<S> force = F::reduced_force(body_[b], mechanism_.bodies[b].inertia, wrench.n_bar);
    right_side_.body[b] = {padded<S>(wrench.F), padded<S>(force)};
  }

  void assemble_closings(const S& t) {
    for (const ClosingJoint& closing : closings_) assemble_closing(closing, t);
    for (const int edge : others_) assemble_rows(edge, t);
  }

  void apply_effects(const S& t) {
    for (Wrench<S>& w : wrenches_) w = {};
    mechanism_.effects.apply(EffectView<S>{mechanism_.bodies, motion_, t}, wrenches_);
  }

  void assemble_link(const LinkJoint& link, const S& t) {
    PointRows<S>& rows = matrix_.point[link.link];
    Vector6<S>& gamma = right_side_.edge[link.edge];
    if (link.child_is_j)
      link.joint.evaluate(turning_, body_, t, rows.L_parent, rows.L_child, rows.W_parent, rows.W_child,
                          gamma);
    else
      link.joint.evaluate(turning_, body_, t, rows.L_child, rows.L_parent, rows.W_child, rows.W_parent,
                          gamma);
  }

  void assemble_closing(const ClosingJoint& closing, const S& t) {
    EdgeRows<S>& rows = matrix_.rows[solver_.plan().rows_slot[closing.edge]];
    closing.joint.evaluate(turning_, body_, t, rows.C_i.x.template leftCols<3>(),
                           rows.C_j.x.template leftCols<3>(), rows.C_i.x.template rightCols<3>(),
                           rows.C_j.x.template rightCols<3>(), right_side_.edge[closing.edge]);
    rows.C_i.x.template leftCols<3>() *= S(-1);
  }

  void assemble_rows(int e, const S& t) {
    const GraphEdge& edge = solver_.plan().graph.edges[e];
    EdgeRows<S>& rows = matrix_.rows[solver_.plan().rows_slot[e]];
    for (int k = 0; k < edge.size(); ++k) {
      const auto& constraint = mechanism_.rows[edge.rows[k]];
      const BodyPair pair = bodies_of(constraint);
      const auto row = evaluate_row(constraint, body_[pair.i], body_[pair.j], t);
      const auto place = [&](BodyColumns<S>& C, const auto& r, const auto& x) {
        C.r.col(k) = padded<S>(r.transpose());
        C.x.col(k) = padded<S>(x.transpose());
      };
      place(pair.i == edge.i ? rows.C_i : rows.C_j, row.r_i, row.rot_i);
      place(pair.i == edge.i ? rows.C_j : rows.C_i, row.r_j, row.rot_j);
      right_side_.edge[e][k] = row.gamma;
    }
  }

  void measure_and_add_step() {
    S moved(0), size(0);
    for (int b = 0; b < mechanism_.nb(); ++b) {
      const auto energy = [&](const BodyPart<S>& a) {
        return S(mechanism_.bodies[b].mass * a.r.squaredNorm() + a.x.dot(times<S, 3>(matrix_.H[b].xx, a.x)));
      };
      moved += energy(step_.body[b]);
      solution_.body[b] += step_.body[b];
      size += energy(solution_.body[b]);
    }
    WrenchSize lambda_moved, lambda_size;
    const EliminationPlan& plan = solver_.plan();
    for (std::size_t e = 0; e < plan.graph.edges.size(); ++e) solution_.edge[e] += step_.edge[e];
    for (const LinkJoint& link : links_) {
      const PointRows<S>& rows = matrix_.point[link.link];
      lambda_moved.add(rows, step_.edge[link.edge], link.joint.size());
      lambda_size.add(rows, solution_.edge[link.edge], link.joint.size());
    }
    const auto measure = [&](int e) {
      const GraphEdge& edge = plan.graph.edges[e];
      const EdgeRows<S>& rows = matrix_.rows[plan.rows_slot[e]];
      const BodyColumns<S>& C = edge.j == plan.graph.bodies ? rows.C_i : rows.C_j;
      lambda_moved.add(C, step_.edge[e], edge.size());
      lambda_size.add(C, solution_.edge[e], edge.size());
    };
    for (const ClosingJoint& closing : closings_) measure(closing.edge);
    for (const int e : others_) measure(e);
    const auto ratio = [](const S& difference, const S& whole) {
      return std::sqrt(largest_lane(S(select(difference == S(0), S(0), S(difference / whole)))));
    };
    const double forces = ratio(lambda_moved.force, lambda_size.force),
                 moments = ratio(lambda_moved.moment, lambda_size.moment);
    corrections_ = {ratio(moved, size), std::isnan(moments) ? moments : std::max(forces, moments)};
  }

  /// Sums of squares of what single multipliers do to a body.
  struct WrenchSize {
    S force{0}, moment{0};

    void add(const PointRows<S>& rows, const Vector6<S>& lambda, int orientations) {
      const Padded<S> f = padded<S>(lambda.template head<3>());
      force += f.squaredNorm();
      moment += times<S, 3>(rows.L_child, f).squaredNorm();
      for (int k = 0; k < orientations; ++k)
        moment += lambda[3 + k] * lambda[3 + k] * rows.W_child.col(k).squaredNorm();
    }
    void add(const BodyColumns<S>& C, const Vector6<S>& lambda, int size) {
      for (int k = 0; k < size; ++k) {
        force += lambda[k] * lambda[k] * C.r.col(k).squaredNorm();
        moment += lambda[k] * lambda[k] * C.x.col(k).squaredNorm();
      }
    }
  };

  /// Null space of Phi^T, a column per dropped row.
  MatrixX<S> idle_combinations();
  /// Per row the sum over its bodies of norm2(body, r, x) of what the row does there.
  template <class Norm2>
  VectorX<S> row_sizes(const Norm2& norm2) const;

  template <class Visit>
  void for_each_row(const Visit& visit) const {
    const auto& edges = solver_.plan().graph.edges;
    for (std::size_t e = 0; e < edges.size(); ++e)
      for (int k = 0; k < edges[e].size(); ++k) visit(static_cast<int>(e), k, edges[e].rows[k]);
  }

  const Mechanism<S>& mechanism_;
  GraphSolver<S> solver_;
  GraphMatrix<S> matrix_;
  GraphVector<S> right_side_, solution_, defect_, step_;
  std::vector<Body> body_;  ///< nb + 1, the ground last, and so
  std::vector<Turning<S>> turning_;
  std::vector<Wrench<S>> wrenches_;
  std::vector<BodyMotion<S>> motion_;
  std::vector<LinkJoint> links_;
  std::vector<ClosingJoint> closings_;
  std::vector<int> others_;  ///< edges that are not point joints
  std::vector<int> ranked_;  ///< edges whose rows may be left out: all but the point joints of the tree
  Corrections corrections_;
};

template <Formulation F>
MatrixX<typename F::Scalar> AccelerationSolver<F>::idle_combinations() {
  const std::vector<int> dropped = dropped_rows();
  MatrixX<S> N = MatrixX<S>::Zero(mechanism_.nc(), static_cast<Eigen::Index>(dropped.size()));
  const auto& edges = solver_.plan().graph.edges;
  GraphVector<S> unit(solver_.plan().graph), combination(unit);
  for_each_row([&](int edge, int k, int row) {
    if (!solver_.is_dropped(edge, k)) return;
    const auto n = std::lower_bound(dropped.begin(), dropped.end(), row) - dropped.begin();
    // what the row does to its bodies, done by the others
    std::fill(unit.body.begin(), unit.body.end(), BodyPart<S>{});
    const EdgeRows<S>& rows = matrix_.rows[solver_.plan().rows_slot[edge]];
    unit.body[edges[edge].i] += BodyPart<S>{-rows.C_i.r.col(k), -rows.C_i.x.col(k)};
    unit.body[edges[edge].j] += BodyPart<S>{-rows.C_j.r.col(k), -rows.C_j.x.col(k)};
    solver_.solve(unit, combination);
    for_each_row([&](int other, int m, int other_row) { N(other_row, n) = combination.edge[other][m]; });
    N(row, n) = S(1);
  });
  return N;
}

template <Formulation F>
template <class Norm2>
VectorX<typename F::Scalar> AccelerationSolver<F>::row_sizes(const Norm2& norm2) const {
  const EliminationPlan& plan = solver_.plan();
  VectorX<S> E2 = VectorX<S>::Zero(mechanism_.nc());
  const auto add = [&](int body, int row, const Padded<S>& r, const Padded<S>& x) {
    if (body != plan.graph.bodies) E2[row] += norm2(body, unpadded<S>(r), unpadded<S>(x));
  };
  for (const LinkJoint& joint : links_) {
    const EliminationPlan::Link& link = plan.links[joint.link];
    const PointRows<S>& rows = matrix_.point[joint.link];
    const std::vector<int>& row = plan.graph.edges[joint.edge].rows;
    for (int k = 0; k < static_cast<int>(row.size()); ++k) {
      const bool is_point = k < 3;
      const Padded<S> r = is_point ? padded<S>(Vector3<S>::Unit(k)) : Padded<S>(Padded<S>::Zero());
      add(link.body, row[k], r, is_point ? rows.L_child.col(k) : rows.W_child.col(k - 3));
      add(link.parent, row[k], r, is_point ? rows.L_parent.col(k) : rows.W_parent.col(k - 3));
    }
  }
  for (std::size_t e = 0; e < plan.graph.edges.size(); ++e) {
    if (plan.rows_slot[e] < 0) continue;
    const GraphEdge& edge = plan.graph.edges[e];
    const EdgeRows<S>& rows = matrix_.rows[plan.rows_slot[e]];
    for (int k = 0; k < edge.size(); ++k) {
      add(edge.i, edge.rows[k], rows.C_i.r.col(k), rows.C_i.x.col(k));
      add(edge.j, edge.rows[k], rows.C_j.r.col(k), rows.C_j.x.col(k));
    }
  }
  return E2;
}

template <Formulation F>
std::vector<bool> AccelerationSolver<F>::unique() {
  std::vector<bool> flags(mechanism_.nc(), true);
  const MatrixX<S> N = idle_combinations();
  if (N.cols() == 0) return flags;
  // a combination is judged row by row by what each could do to its bodies
  const VectorX<S> E2 = row_sizes([&](int b, const Vector3<S>& r, const Vector3<S>& x) {
    const S moments = matrix_.H[b].xx(0, 0) + matrix_.H[b].xx(1, 1) + matrix_.H[b].xx(2, 2);
    const S by_moment = moments > S(0) ? S(x.squaredNorm() / moments) : S(0);
    return S(r.squaredNorm() / mechanism_.bodies[b].mass + by_moment);
  });
  for (Eigen::Index n = 0; n < N.cols(); ++n) {
    S largest(0);
    for (int row = 0; row < mechanism_.nc(); ++row) {
      const S size = N(row, n) * N(row, n) * E2[row];
      largest = select(size > largest, size, largest);
    }
    for (int row = 0; row < mechanism_.nc(); ++row)
      if (N(row, n) * N(row, n) * E2[row] > S(1e-12) * largest) flags[row] = false;
  }
  return flags;
}

template <Formulation F>
VectorX<typename F::Scalar> AccelerationSolver<F>::minimum_norm_lambda() {
  VectorX<S> all = lambda();
  const MatrixX<S> N = idle_combinations();
  if (N.cols() == 0) return all;
  const VectorX<S> E2 = row_sizes([&](int b, const Vector3<S>& r, const Vector3<S>& x) {
    const Matrix3<S> J = matrix_.H[b].xx.template topRows<3>();
    const S moments = J.trace() / 3;
    if (!(J.determinant() > unit_roundoff<S>() * moments * moments * moments))
      throw ModelError(
          fmt::format("body \"{}\" has no inertia about an axis, so that its share in E is not "
                      "defined: ask the printed system for the minimum norm",
                      mechanism_.body_names[b]));
    return S(r.squaredNorm() / mechanism_.bodies[b].mass + x.dot(J.inverse() * x));
  });
  const MatrixX<S> gram = N.transpose() * E2.asDiagonal() * N;
  return all - N * gram.ldlt().solve(N.transpose() * E2.cwiseProduct(all));
}

}  // namespace trivium
