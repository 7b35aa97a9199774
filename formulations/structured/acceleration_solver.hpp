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

#include "formulations/structured/baumgarte.hpp"
#include "formulations/structured/graph_assembly.hpp"
#include "formulations/structured/graph_solver.hpp"
#include "formulations/structured/row_violation.hpp"

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
        assembly_(mechanism, solver_.plan()),
        right_side_(solver_.plan().graph),
        solution_(right_side_),
        defect_(right_side_),
        step_(right_side_),
        wrenches_(mechanism.nb() + 1),
        motion_(mechanism.nb() + 1) {
    for (int e = 0; e < static_cast<int>(plan().graph.edges.size()); ++e)
      if (plan().rows_slot[e] >= 0) candidate_edges_.push_back(e);
  }
  AccelerationSolver(const AccelerationSolver&) = delete;  // its solver knows where its matrix is

  /// Solves at a state. Throws a ModelError that names the body where a link is singular, and the row where
  /// redundant rows contradict each other; all answers are NaN then.
  void solve(std::span<const BodyState<F>> state, const S& t, Refinement refinement = Refinement::as_needed,
             DependentRows how = DependentRows::detect) {
    try {
      rows_are_decided_ = how != DependentRows::detect;
      solver_.set_dependent_rows(how);
      t_ = t;
      refinement_ = refinement;
      move_bodies(state);
      if (how == DependentRows::detect_near_singular)
        assembly_.find_vanishing_rows(S(vanishing_row_tolerance),
                                      [&](int edge, int k) { solver_.mark_dependent(edge, k); });
      if (baumgarte_) measure_violations();
      assembly_.assemble_closings(t_, right_side_);
      if (baumgarte_)
        for (const int e : candidate_edges_) stabilise(e);
      solver_.start(assembly_.matrix(), right_side_);
      eliminate();
      solver_.substitute(solution_);
      if (refinement == Refinement::as_needed) refine_as_needed();
      if (how == DependentRows::detect) check_dependent_rows();
    } catch (...) {
      forget();
      throw;
    }
  }

  /// From now on accelerations are those of the stabilised rows.
  void stabilise(const Baumgarte& baumgarte) {
    baumgarte_ = baumgarte;
    phi_.emplace(plan().graph);
    phi_dot_.emplace(plan().graph);
  }

  /// One step of iterative refinement.
  void refine() {
    refinement_ = Refinement::as_needed;
    solver_.correct(assembly_.matrix(), right_side_, solution_, step_, step_);
    measure_and_add_step();
  }

  const Mechanism<S>& mechanism() const { return mechanism_; }
  const EliminationPlan& plan() const { return solver_.plan(); }
  /// For other right sides of the same matrix; what is done to them voids the accelerations.
  GraphSolver<S>& factors() { return solver_; }
  GraphAssembly<F>& assembly() { return assembly_; }
  const GraphAssembly<F>& assembly() const { return assembly_; }
  /// What went wrong at a link, with its body's name; that of a state that is not finite comes first.
  ModelError named(const SingularLink& link, const S& t) const {
    require_numbers();
    return ModelError(
        fmt::format("body \"{}\" at t = {}: {}; its links cannot be eliminated one by one: solve the printed "
                    "system instead",
                    mechanism_.body_names[link.body()], static_cast<double>(t), link.what()));
  }
  /// Of the last refinement.
  const Corrections& corrections() const { return corrections_; }

  Vector3<S> r_ddot(int b) const { return unpadded<S>(solution_.body[b].r); }
  /// The formulation's own unknown.
  typename F::Unknown q_ddot(int b) const {
    return F::from_reduced(assembly_.body()[b], unpadded<S>(solution_.body[b].x));
  }
  Vector3<S> omega_bar_dot(int b) const { return F::to_angular_acceleration(assembly_.body()[b], q_ddot(b)); }
  /// One multiplier per row of the mechanism; 0 in dependent rows.
  VectorX<S> lambda() const {
    VectorX<S> all(mechanism_.nc());
    copy_lambda(all);
    return all;
  }
  /// The same into a vector of that size.
  void copy_lambda(VectorX<S>& all) const {
    for_each_row([&](int edge, int k, int row) { all[row] = solution_.edge[edge][k]; });
  }
  /// Which rows depend on others is decided here where the solution left it open; multipliers of rows that do
  /// not may then change from 0, within what rounding leaves of them.
  std::vector<int> dependent_rows() {
    decide_dependent_rows();
    std::vector<int> rows;
    for_each_row([&](int edge, int k, int row) {
      if (solver_.is_dependent(edge, k)) rows.push_back(row);
    });
    std::sort(rows.begin(), rows.end());
    return rows;
  }
  int rank() { return mechanism_.nc() - static_cast<int>(dependent_rows().size()); }

  // on demand, one solve per dependent row; not for the timed path

  /// Which multipliers are unique: those that no combination that acts on nothing contains.
  std::vector<bool> unique();
  /// Lambda of minimum |E lambda| among those with the same Phi^T lambda, E = diag(Phi M^-1 Phi^T)^(1/2).
  /// Throws a ModelError that names the body where M is singular and the choice matters.
  VectorX<S> minimum_norm_lambda();

 private:
  /// Link by link, each joint evaluated just before its step.
  void eliminate() {
    const auto& links = assembly_.links();
    auto joint = links.begin();
    try {
      for (int step = 0; step < solver_.steps(); ++step) {
        if (joint != links.end() && joint->link == plan().steps[step].link) assemble_link(*joint++);
        solver_.eliminate(step, right_side_);
      }
    } catch (const SingularLink& e) {
      throw named(e, t_);
    }
  }

  void assemble_link(const typename GraphAssembly<F>::LinkJoint& link) {
    assembly_.assemble_link(link, t_, right_side_);
    if (baumgarte_) stabilise(link.edge);
  }
  void measure_violations() {
    assembly_.positions(t_, *phi_);
    assembly_.velocities(t_, *phi_dot_);
  }
  void stabilise(int edge) {
    const auto& [alpha, beta] = *baumgarte_;
    right_side_.edge[edge] -= S(2 * alpha) * phi_dot_->edge[edge] + S(beta * beta) * phi_->edge[edge];
  }

  // dependent rows (dependent_rows_check_impl.hpp)

  /// Dependent rows are combinations of the others, so that their right sides must be the same
  /// combinations; or they are none, and are solved for then.
  void check_dependent_rows();
  template <class SizeOfBody>
  std::optional<EdgeRow> find_violated_row(const GraphVector<S>& solution, const S& tolerance, const S& least,
                                           const SizeOfBody& size_of_body) const;
  /// Of a body's accelerations, and of what its forces and its turning could cause: forces in balance leave
  /// accelerations that are rounding.
  AccelerationSize<S> size_of_causes(int b) const;
  /// With levers, what gamma is made of.
  AccelerationSize<S> size_of_turning(int b) const {
    return {S(0), assembly_.turning()[b].omega.squaredNorm()};
  }
  /// Tells rows that depend on others from those that nearly do, and solves for these as well; once a state.
  void decide_dependent_rows();
  const std::string& row_name(const EdgeRow& row) const {
    return mechanism_.row_names[plan().graph.edges[row.edge].rows[row.k]];
  }
  [[noreturn]] void throw_violated(const EdgeRow& row) const;

  /// Throws a ModelError that names the body whose state is not a number.
  void require_numbers() const {
    using std::isfinite;
    for (int b = 0; b < mechanism_.nb(); ++b) {
      const AngularMotion<S>& turning = assembly_.turning()[b];
      const Body& body = assembly_.body()[b];
      if (!isfinite(S(turning.A.sum() + turning.omega.sum() + body.r.sum() + body.r_dot.sum())))
        throw ModelError(fmt::format("body \"{}\" at t = {}: its state is not finite",
                                     mechanism_.body_names[b], static_cast<double>(t_)));
    }
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
      assembly_.move_body(b, state[b]);
      if (!effects_see_motion) push_body(b);
    }
    if (!effects_see_motion) return;
    std::copy(assembly_.body().begin(), assembly_.body().end(), motion_.begin());
    apply_effects();
    for (int b = 0; b < mechanism_.nb(); ++b) push_body(b);
  }
  [[gnu::flatten]] void push_body(int b) {
    const Wrench<S>& wrench = wrenches_[b];
    const Vector3<S> force =
        F::reduced_force(assembly_.body()[b], mechanism_.bodies[b].inertia, wrench.n_bar);
    right_side_.body[b] = {padded<S>(wrench.F), padded<S>(force)};
  }

  void apply_effects() {
    for (Wrench<S>& w : wrenches_) w = {};
    mechanism_.effects.apply(EffectView<S>{mechanism_.bodies, motion_, t_}, wrenches_);
  }

  void measure_and_add_step() {
    // by components, added up once at the end; link by link, those first that were solved for last
    Padded<S> moved = Padded<S>::Zero(), size = moved;
    WrenchSize lambda_moved, lambda_size;
    const EliminationPlan& plan = solver_.plan();
    const GraphMatrix<S>& matrix = assembly_.matrix();
    auto joint = assembly_.links().begin();
    for (int n = 0; n < static_cast<int>(plan.links.size()); ++n) {
      const int b = plan.links[n].body;
      const auto add_energy = [&](const BodyPart<S>& a, Padded<S>& sum) {
        sum +=
            mechanism_.bodies[b].mass * a.r.cwiseAbs2() + a.x.cwiseProduct(times<S, 3>(matrix.H[b].xx, a.x));
      };
      add_energy(step_.body[b], moved);
      solution_.body[b] += step_.body[b];
      add_energy(solution_.body[b], size);
      if (joint == assembly_.links().end() || joint->link != n) continue;
      const PointRows<S>& rows = matrix.point[n];
      const int e = joint->edge, orientations = joint->joint.size();
      lambda_moved.add(rows, step_.edge[e], orientations);
      solution_.edge[e] += step_.edge[e];
      lambda_size.add(rows, solution_.edge[e], orientations);
      ++joint;
    }
    for (const int e : candidate_edges_) {
      const GraphEdge& edge = plan.graph.edges[e];
      const EdgeRows<S>& rows = matrix.rows[plan.rows_slot[e]];
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

  /// Null space of Phi^T, a column per dependent row.
  MatrixX<S> left_null_space();
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
  GraphAssembly<F> assembly_;
  GraphVector<S> right_side_, solution_, defect_, step_;
  std::vector<Wrench<S>> wrenches_;  ///< nb + 1, the ground's last, and so
  std::vector<BodyMotion<S>> motion_;
  std::vector<int>
      candidate_edges_;  ///< edges whose rows may be dependent: all but the point joints of the tree
  // of the last state
  S t_{0};
  Refinement refinement_ = Refinement::as_needed;
  bool rows_are_decided_ = false;  ///< the dependent ones all depend on others
  Corrections corrections_;
  // where rows are stabilised
  std::optional<Baumgarte> baumgarte_;
  std::optional<GraphVector<S>> phi_, phi_dot_;
};

}  // namespace trivium

#include "bodies/numbers/scalar.hpp"
#include "formulations/structured/dependent_rows_check_impl.hpp"
#include "formulations/structured/unique_multipliers_impl.hpp"
