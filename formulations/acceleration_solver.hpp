#pragma once
/// Accelerations and multipliers of one formulation in O(nb): the augmented system with its normalisation
/// rows eliminated in closed form, assembled joint by joint and solved along the body-joint graph. One object
/// per mechanism, planned once; solving again at another state allocates nothing.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "formulations/equations_of_motion.hpp"
#include "formulations/graph_solver.hpp"
#include "formulations/point_joint.hpp"
#include "formulations/unmet_rows.hpp"

namespace trivium {

/// What the last refinement corrected, relative: accelerations in the mass metric; multipliers by the forces
/// and by the moments that they exert, whichever is worse. It is the error before that refinement, over the
/// whole mechanism: of a body far lighter than others it may be more; what is left is smaller. Where forces
/// in balance leave no acceleration, all of it is correction.
struct Corrections {
  double acceleration = 0, lambda = 0;
};

/// As needed: once, and again where the corrections say that more than rounding is left, as where a light
/// body holds a heavy one.
enum class Refinement { none, as_needed };

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
    for (int b = 0; b < mechanism.nb(); ++b) {
      matrix_.H[b].rr.diagonal().setConstant(mechanism.bodies[b].mass);
      if constexpr (F::reduced_mass_is_constant) set_mass_block(b);
    }
    plan_assembly();
  }
  AccelerationSolver(const AccelerationSolver&) = delete;  // its solver knows where its matrix is

  /// Solves at a state. Throws a ModelError that names the body where a link is singular, and the row where
  /// redundant rows contradict each other; all answers are NaN then.
  void solve(std::span<const BodyState<F>> state, const S& t, Refinement refinement = Refinement::as_needed) {
    try {
      rows_are_settled_ = false;
      t_ = t;
      refinement_ = refinement;
      move_bodies(state);
      assemble_closings();
      solver_.start(matrix_, right_side_);
      eliminate();
      solver_.substitute(solution_);
      if (refinement == Refinement::as_needed) refine_as_needed();
      meet_left_out_rows();
    } catch (...) {
      forget();
      throw;
    }
  }

  /// One step of iterative refinement.
  void refine() {
    refinement_ = Refinement::as_needed;
    solver_.correct(matrix_, right_side_, solution_, step_, step_);
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
  /// Which rows depend on others is settled here where the solution left it open; multipliers of rows that do
  /// not may then change from 0, within what rounding leaves of them.
  std::vector<int> dropped_rows() {
    settle_rows();
    std::vector<int> rows;
    for_each_row([&](int edge, int k, int row) {
      if (solver_.is_dropped(edge, k)) rows.push_back(row);
    });
    std::sort(rows.begin(), rows.end());
    return rows;
  }
  int rank() { return mechanism_.nc() - static_cast<int>(dropped_rows().size()); }

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
  void eliminate() {
    auto joint = links_.begin();
    try {
      for (int step = 0; step < solver_.steps(); ++step) {
        if (joint != links_.end() && joint->link == solver_.plan().steps[step].link) assemble_link(*joint++);
        solver_.eliminate(step, right_side_);
      }
    } catch (const SingularLink& e) {
      require_numbers();
      throw ModelError(
          fmt::format("body \"{}\" at t = {}: {}; its links cannot be eliminated one by one: solve the "
                      "printed system instead",
                      mechanism_.body_names[e.body()], static_cast<double>(t_), e.what()));
    }
  }

  /// Rows that were left out are combinations of the others, so that their right sides must be the same
  /// combinations; or they are none, and are solved for then.
  void meet_left_out_rows() {
    if (ranked_.empty()) return;
    const auto size_here = [&](int b) { return size_of_causes(b); };
    // what refinement leaves of rows that depend on others stays below
    const S rounding = S(8 * unit_roundoff<S>());
    if (!solver_.has_thin_rows() && !find_unmet_row(solution_, rounding, S(0), size_here)) return;
    settle_rows();
    // least: what velocities of rounding size leave
    const S tolerance = larger(S(1e-6), S(30 * direction_tolerance<S>())), least = S(1e-12);
    if (!find_unmet_row(solution_, S(1e-3 * tolerance), least, size_here)) return;
    PartSize<S> whole, turning;
    for (int b = 0; b < mechanism_.nb(); ++b) {
      whole.take(size_of_causes(b));
      turning.take(size_of_turning(b));
    }
    if (const auto row = find_unmet_row(solution_, tolerance, least, [&](int) { return whole; }))
      throw_unmet(*row);
    // how much of it is rounding of the forces shows without them
    for (BodyPart<S>& force : right_side_.body) force = {};
    solver_.solve(right_side_, step_);
    solver_.correct(matrix_, right_side_, step_, defect_, defect_);
    whole = turning;
    for (int b = 0; b < mechanism_.nb(); ++b) {
      step_.body[b] += defect_.body[b];
      push_body(b);
      whole.take(PartSize<S>::of(step_.body[b]));
    }
    if (const auto row = find_unmet_row(step_, tolerance, least, [&](int) { return whole; }))
      throw_unmet(*row);
  }
  template <class SizeOfBody>
  std::optional<EdgeRow> find_unmet_row(const GraphVector<S>& solution, const S& tolerance, const S& least,
                                        const SizeOfBody& size_of_body) const {
    return trivium::find_unmet_row<S>(solver_, ranked_, matrix_, right_side_, solution, tolerance, least,
                                      size_of_body);
  }
  /// Of a body's accelerations, and of what its forces and its turning could cause: forces in balance leave
  /// accelerations that are rounding.
  PartSize<S> size_of_causes(int b) const {
    const S moments = matrix_.H[b].xx.diagonal().sum();
    const auto force = PartSize<S>::of(right_side_.body[b]);
    auto size = PartSize<S>::of(solution_.body[b]);
    size.take({S(force.r / mechanism_.bodies[b].mass), select(moments > S(0), S(force.x / moments), S(0))});
    size.take(size_of_turning(b));
    return size;
  }
  /// With levers, what gamma is made of.
  PartSize<S> size_of_turning(int b) const { return {S(0), turning_[b].omega.squaredNorm()}; }
  /// Tells rows that depend on others from those that nearly do, and solves for these as well; once a state.
  void settle_rows() {
    if (std::exchange(rows_are_settled_, true)) return;
    try {
      if (!solver_.reinstate_rows()) return;
    } catch (const NearlyDependentRows& e) {
      throw ModelError(fmt::format(
          "row \"{}\" at t = {}: it is one of more than {} that depend on others nearly, but not quite, as "
          "where positions miss their constraints by a little: assemble them first, or solve the printed "
          "system",
          row_name(e.first_too_many), static_cast<double>(t_), solver_.most_reinstated));
    }
    solver_.solve(right_side_, solution_);
    if (refinement_ == Refinement::as_needed) refine_as_needed();
  }
  const std::string& row_name(const EdgeRow& row) const {
    return mechanism_.row_names[solver_.plan().graph.edges[row.edge].rows[row.k]];
  }
  [[noreturn]] void throw_unmet(const EdgeRow& row) const {
    require_numbers();
    throw ModelError(
        fmt::format("row \"{}\" at t = {}: it depends on other rows and asks for another acceleration than "
                    "they do. Either none satisfies all: remove a row, or make their functions of time "
                    "agree; or what is left of it beside them is rounding: take a wider Scalar, or solve the "
                    "printed system",
                    row_name(row), static_cast<double>(t_)));
  }
  /// Throws a ModelError that names the body whose state is not a number.
  void require_numbers() const {
    using std::isfinite;
    for (int b = 0; b < mechanism_.nb(); ++b)
      if (!isfinite(
              S(turning_[b].A.sum() + turning_[b].omega.sum() + body_[b].r.sum() + body_[b].r_dot.sum())))
        throw ModelError(fmt::format("body \"{}\" at t = {}: its state is not finite",
                                     mechanism_.body_names[b], static_cast<double>(t_)));
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

  /// Until what is left, as far as the corrections fall alike, is far below rounding; or they fall no more.
  void refine_as_needed() {
    const double enough = 1e-4 * static_cast<double>(unit_roundoff<S>());
    double before = 3;  // above any first correction
    for (;;) {
      refine();
      const double now = std::max(corrections_.acceleration, corrections_.lambda);
      if (!(now < before / 2 && now * now / before > enough)) return;
      before = now;
    }
  }
  void move_bodies(std::span<const BodyState<F>> state) {
    const bool effects_see_motion = mechanism_.effects.see_motion();
    if (!effects_see_motion) apply_effects();
    for (int b = 0; b < mechanism_.nb(); ++b) {
      move_body(b, state[b]);
      if (!effects_see_motion) push_body(b);
    }
    if (!effects_see_motion) return;
    std::copy(body_.begin(), body_.end(), motion_.begin());
    apply_effects();
    for (int b = 0; b < mechanism_.nb(); ++b) push_body(b);
  }
  [[gnu::flatten]] void move_body(int b, const BodyState<F>& state) {
    body_[b] = Body{F::kinematics(state.chart, state.r, state.r_dot, state.q)};
    turning_[b] = F::turning(body_[b]);
    if constexpr (!F::reduced_mass_is_constant) set_mass_block(b);
  }
  void set_mass_block(int b) {
    matrix_.H[b].xx = padded_columns<S>(F::reduced_mass_block(body_[b], mechanism_.bodies[b].inertia));
  }
  [[gnu::flatten]] void push_body(int b) {
    const Wrench<S>& wrench = wrenches_[b];
    const Vector3<S> force = F::reduced_force(body_[b], mechanism_.bodies[b].inertia, wrench.n_bar);
    right_side_.body[b] = {padded<S>(wrench.F), padded<S>(force)};
  }

  void assemble_closings() {
    for (const ClosingJoint& closing : closings_) assemble_closing(closing);
    for (const int edge : others_) assemble_rows(edge);
  }

  void apply_effects() {
    for (Wrench<S>& w : wrenches_) w = {};
    mechanism_.effects.apply(EffectView<S>{mechanism_.bodies, motion_, t_}, wrenches_);
  }

  void assemble_link(const LinkJoint& link) {
    PointRows<S>& rows = matrix_.point[link.link];
    Vector6<S>& gamma = right_side_.edge[link.edge];
    if (link.child_is_j)
      link.joint.evaluate(turning_, body_, t_, rows.L_parent, rows.L_child, rows.W_parent, rows.W_child,
                          gamma);
    else
      link.joint.evaluate(turning_, body_, t_, rows.L_child, rows.L_parent, rows.W_child, rows.W_parent,
                          gamma);
  }

  void assemble_closing(const ClosingJoint& closing) {
    EdgeRows<S>& rows = matrix_.rows[solver_.plan().rows_slot[closing.edge]];
    closing.joint.evaluate(turning_, body_, t_, rows.C_i.x.template leftCols<3>(),
                           rows.C_j.x.template leftCols<3>(), rows.C_i.x.template rightCols<3>(),
                           rows.C_j.x.template rightCols<3>(), right_side_.edge[closing.edge]);
    rows.C_i.x.template leftCols<3>() *= S(-1);
  }

  void assemble_rows(int e) {
    const GraphEdge& edge = solver_.plan().graph.edges[e];
    EdgeRows<S>& rows = matrix_.rows[solver_.plan().rows_slot[e]];
    for (int k = 0; k < edge.size(); ++k) {
      const auto& constraint = mechanism_.rows[edge.rows[k]];
      const BodyPair pair = bodies_of(constraint);
      const auto row = evaluate_row(constraint, body_[pair.i], body_[pair.j], t_);
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
    // by components, added up once at the end; link by link, those first that were solved for last
    Padded<S> moved = Padded<S>::Zero(), size = moved;
    WrenchSize lambda_moved, lambda_size;
    const EliminationPlan& plan = solver_.plan();
    auto joint = links_.begin();
    for (int n = 0; n < static_cast<int>(plan.links.size()); ++n) {
      const int b = plan.links[n].body;
      const auto add_energy = [&](const BodyPart<S>& a, Padded<S>& sum) {
        sum +=
            mechanism_.bodies[b].mass * a.r.cwiseAbs2() + a.x.cwiseProduct(times<S, 3>(matrix_.H[b].xx, a.x));
      };
      add_energy(step_.body[b], moved);
      solution_.body[b] += step_.body[b];
      add_energy(solution_.body[b], size);
      if (joint == links_.end() || joint->link != n) continue;
      const PointRows<S>& rows = matrix_.point[n];
      const int e = joint->edge, orientations = joint->joint.size();
      lambda_moved.add(rows, step_.edge[e], orientations);
      solution_.edge[e] += step_.edge[e];
      lambda_size.add(rows, solution_.edge[e], orientations);
      ++joint;
    }
    for (const int e : ranked_) {
      const GraphEdge& edge = plan.graph.edges[e];
      const EdgeRows<S>& rows = matrix_.rows[plan.rows_slot[e]];
      const BodyColumns<S>& C = edge.j == plan.graph.bodies ? rows.C_i : rows.C_j;
      lambda_moved.add(C, step_.edge[e], edge.size());
      solution_.edge[e] += step_.edge[e];
      lambda_size.add(C, solution_.edge[e], edge.size());
    }
    const auto ratio = [](const Padded<S>& differences, const Padded<S>& wholes) {
      const S difference = differences.sum(), whole = wholes.sum();
      return std::sqrt(largest_lane(S(select(difference == S(0), S(0), S(difference / whole)))));
    };
    const double forces = ratio(lambda_moved.force, lambda_size.force),
                 moments = ratio(lambda_moved.moment, lambda_size.moment);
    // beside nothing, all is correction
    const auto share = [](double x) { return x > 1 ? 1.0 : x; };
    corrections_ = {share(ratio(moved, size)),
                    share(std::isnan(moments) ? moments : std::max(forces, moments))};
  }

  /// Sums of squares, by components, of what single multipliers do to a body.
  struct WrenchSize {
    Padded<S> force = Padded<S>::Zero(), moment = force;

    void add(const PointRows<S>& rows, const Vector6<S>& lambda, int orientations) {
      const Padded<S> f = padded<S>(lambda.template head<3>());
      force += f.cwiseAbs2();
      moment += times<S, 3>(rows.L_child, f).cwiseAbs2();
      for (int k = 0; k < orientations; ++k) moment += (lambda[3 + k] * rows.W_child.col(k)).cwiseAbs2();
    }
    void add(const BodyColumns<S>& C, const Vector6<S>& lambda, int size) {
      for (int k = 0; k < size; ++k) {
        force += (lambda[k] * C.r.col(k)).cwiseAbs2();
        moment += (lambda[k] * C.x.col(k)).cwiseAbs2();
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
  // of the last state
  S t_{0};
  Refinement refinement_ = Refinement::as_needed;
  bool rows_are_settled_ = false;  ///< those left out all depend on others
  Corrections corrections_;
};

}  // namespace trivium

#include "formulations/unique_multipliers_impl.hpp"
