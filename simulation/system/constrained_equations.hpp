#pragma once
/// The equations of motion of one formulation with their constraints, for implicit methods:
///
///     M(q) v' + Phi_q^T lambda = Q(q, v, t),   Phi(q, t) = 0
///
/// The state is y = (q, v, work), as in FirstOrderEquations. Residuals are in reduced unknowns, with three
/// numbers of rotation per body; the internal row p . p = 1 of r-p is met by `normalise_step`. Newton's
/// system of a step is in reduced unknowns as well:
///
///     [ M + gamma' C + beta' K   Phi_q^T ] [ dv'     ]     [ M v' + Phi_q^T lambda - Q ]
///     [ Phi_q                    0       ] [ dlambda ] = - [ Phi / beta'               ]
///
/// beta' [s^2] and gamma' [s] are numbers of the method, of order h^2 and h (integrators::Shares): within the
/// step, a change dv' of v' changes q by beta' dv' and v by gamma' dv'. The primes of beta' and gamma' are
/// part of these names; all other primes are derivatives by time. The division of Phi by beta' keeps the
/// condition number bounded as h -> 0. K and C hold the stiffness and damping of springs along their
/// directions (spring_rows.hpp). Gyroscopic and geometric terms are left out of the matrix; the Newton
/// iteration therefore converges linearly, with a rate of about the angle [rad] that bodies turn in a step.

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "integrators/contract/constrained_system.hpp"
#include "integrators/contract/tolerances.hpp"
#include "mechanism/reach.hpp"
#include "simulation/system/displacements.hpp"
#include "simulation/system/first_order_equations.hpp"
#include "simulation/system/force_balance.hpp"
#include "simulation/system/newton_matrix.hpp"
#include "simulation/system/spring_rows.hpp"

namespace trivium {

/// The constrained equations of one mechanism in the formulation F. A model of the concept
/// integrators::ConstrainedSystem, which defines its functions. Owns the FirstOrderEquations of the same
/// motion.
template <Formulation F>
class ConstrainedEquations {
 public:
  using Scalar = typename F::Scalar;
  using S = Scalar;
  using StateVector = VectorX<S>;
  using Layout = StateLayout<F>;
  using Evaluation = trivium::Evaluation<F>;
  using Factors = NewtonFactors<F>;
  using Violation = integrators::Violation<S>;

  /// Throws a ModelError that names the body whose chart is singular.
  ConstrainedEquations(const MechanismOf<F>& mechanism, const MechanismState<S>& start,
                       const FirstOrderOptions& options = {})
      : first_order_(mechanism, start, options),
        mechanism_(first_order_.mechanism()),
        layout_(first_order_.layout()),
        displacements_(layout_, first_order_.state(), reaches(mechanism_)),
        plan_(std::make_shared<const EliminationPlan>(plan_elimination(graph_with_springs(mechanism_)))),
        springs_(mechanism_, *plan_),
        matrix_(mechanism_, *plan_),
        balance_(mechanism_, *plan_),
        violation_(mechanism_, plan_->graph, options.first_start(start.t)),
        given_(plan_->graph),
        motion_(nb() + 1),
        wrenches_(nb() + 1) {}

  /// The same motion as y' = f(t, y), with its energies, its poses and twists, and the log of its events.
  FirstOrderEquations<F>& first_order() { return first_order_; }
  const FirstOrderEquations<F>& first_order() const { return first_order_; }
  int nb() const { return mechanism_.nb(); }

  // the functions of integrators::FirstOrderSystem
  int size() const { return first_order_.size(); }
  const StateVector& start() const { return first_order_.start(); }
  void derivative(const S& t, const StateVector& y, StateVector& y_dot) {
    first_order_.derivative(t, y, y_dot);
  }
  Violation position_violation(const S& t, const StateVector& y) {
    return first_order_.position_violation(t, y);
  }
  Violation velocity_violation(const S& t, const StateVector& y) {
    return first_order_.velocity_violation(t, y);
  }
  bool projection_is_too_large(const StateVector& before, const StateVector& stepped,
                               const StateVector& projected) {
    return first_order_.projection_is_too_large(before, stepped, projected);
  }
  S longest_step(const S& t, const StateVector& y) { return first_order_.longest_step(t, y); }
  void correct_positions(const S& t, StateVector& y, bool factor) {
    first_order_.correct_positions(t, y, factor);
  }
  void correct_velocities(const S& t, StateVector& y, bool factor) {
    first_order_.correct_velocities(t, y, factor);
  }
  void normalise(StateVector& y) const { first_order_.normalise(y); }
  bool accept_state(const S& t, StateVector& y) { return first_order_.accept_state(t, y); }
  bool pass_discontinuity(const S& before, const S& t, StateVector& y) {
    return first_order_.pass_discontinuity(before, t, y);
  }
  std::string most_accelerated(const S& t, const StateVector& y) {
    return first_order_.most_accelerated(t, y);
  }
  std::string diagnose(const S& t, const StateVector& y, const S& step) {
    return first_order_.diagnose(t, y, step);
  }

  // the lengths of q, v and lambda; y = (q, v, work)
  int position_size() const { return layout_.position_size(); }
  int velocity_size() const { return layout_.velocity_size(); }
  int multipliers() const { return mechanism_.nc(); }

  /// v' and lambda from the equations of index 1. Throws a ModelError if they have no solution.
  void accelerations(const S& t, const StateVector& y, StateVector& v_dot, StateVector& lambda) {
    const AccelerationSolver<F>& solved = first_order_.solved(t, y);
    v_dot.resize(velocity_size());
    for (int b = 0; b < nb(); ++b) Layout::of(v_dot, b) << solved.r_ddot(b), solved.q_ddot(b);
    lambda.resize(multipliers());
    solved.copy_lambda(lambda);
  }

  // displacements between states (displacements.hpp)
  void displace(const StateVector& from, const StateVector& displacement, StateVector& y) const {
    displacements_.displace(from, displacement, y);
  }
  void displacement(const StateVector& from, const StateVector& to, StateVector& displacement) const {
    displacements_.displacement(from, to, displacement);
  }
  void displacement_rate(const StateVector& displacement, const StateVector& v, StateVector& rate) const {
    displacements_.displacement_rate(displacement, v, rate);
  }
  void position_rate(const StateVector& y, const StateVector& v, StateVector& rate) const {
    displacements_.position_rate(y, v, rate);
  }
  void position_sizes(const StateVector& y, StateVector& sizes) const {
    displacements_.position_sizes(y, sizes);
  }
  bool normalise_step(const S& share, StateVector& y, StateVector& v_dot) const {
    return displacements_.normalise_step(share, y, v_dot);
  }
  void normalise_step_velocity(const S& share, const StateVector& y, StateVector& v_dot) const {
    displacements_.normalise_step_velocity(share, y, v_dot);
  }

  // the equations at a state (evaluation.hpp)
  void evaluate(const S& t, const StateVector& y, Evaluation& at) {
    first_order_.load(y);
    auto& model =
        at.begin(plan_, [&] { return std::make_shared<EvaluatedModel<F>>(mechanism_, plan_, violation_); });
    model.t = t;
    for (int b = 0; b < nb(); ++b) model.assembly.move_body(b, first_order_.state()[b]);
    model.violation.take_fastest(first_order_.measure());
    model.violation.move(model.body());
  }
  /// Whether M does not depend on q.
  bool inertia_is_constant() const { return F::inertia_is_constant; }
  void inertia_force(const Evaluation& at, const StateVector& x, StateVector& force) const {
    inertia_force(at->body(), x, force);
  }
  void inertia_force(const Factors& factors, const StateVector& x, StateVector& force) const {
    inertia_force(factors.at().body(), x, force);
  }
  /// Generalised force of the effects, without gyroscopic terms, with its components in the order of v: per
  /// body a force [N] and one number for each rotational velocity of the formulation.
  void applied_force(const Evaluation& at, StateVector& force) {
    apply_effects(*at);
    force.resize(velocity_size());
    for (int b = 0; b < nb(); ++b)
      Layout::of(force, b) << wrenches_[b].F, F::applied_force(at->body()[b], wrenches_[b].n_bar);
  }
  /// The reduced residual Q - force - Phi_q^T lambda in `left`, where `force` stands for M v'. Returns the
  /// largest residual of a body relative to the forces or moments in its component [-] (force_balance.hpp).
  S residual(const Evaluation& at, const StateVector& force, const StateVector& lambda, StateVector& left) {
    apply_effects(*at);
    assemble(*at);
    return balance_.measure(*at, wrenches_, force, lambda, left);
  }
  /// Phi in the order of the mechanism's rows. Returns the violation of positions, without dependent rows.
  Violation position_rows(const Evaluation& at, StateVector& phi) {
    at->assembly.positions(at->t, given_);
    matrix_.take_rows(given_, phi);
    return without_dependent_rows([&] { return at->violation.measure_positions(given_); });
  }
  /// Phi' = Phi_q q' - nu in the same order. Returns the violation of velocities, without dependent rows.
  Violation velocity_rows(const Evaluation& at, StateVector& phi_dot) {
    at->assembly.velocities(at->t, given_);
    matrix_.take_rows(given_, phi_dot);
    return without_dependent_rows([&] { return at->violation.measure_velocities(given_); });
  }
  void clear_dependent(StateVector& lambda) {
    for_each_dependent_row([&](int e, int k) { lambda[plan_->graph.edges[e].rows[k]] = S(0); });
  }
  const std::string& row_name(int row) const { return violation_.row_name(row); }
  /// The rate of the work done on the mechanism [W].
  S work_rate(const Evaluation& at, const StateVector& lambda) {
    return first_order_.account().power(view(*at), at->body(), lambda);
  }

  // linear systems with Newton's matrix (newton_matrix.hpp)
  /// Throws a ModelError that names the body whose block is singular.
  void factor(const Evaluation& at, const integrators::Shares<S>& shares, Factors& factors) {
    assemble(*at);
    springs_.let_resist(at->assembly, shares.velocity, shares.position);
    matrix_.factor(at, first_order_.solver(), factors);
  }
  void solve(const Factors& factors, const Evaluation& at, const StateVector& left, const StateVector& rows,
             StateVector& x, StateVector& mu) {
    give(left, rows);
    springs_.clear_slack(given_);
    matrix_.solve(factors, at->body(), given_, x, mu);
  }
  void reduce(const Factors& factors, const StateVector& force, StateVector& left) const {
    matrix_.reduce(factors.at().body(), force, left);
  }
  // springs (spring_rows.hpp)
  int springs() const { return springs_.count(); }
  /// Stiffness and damping per spring [N/m, N s/m]; of torsional springs [N m/rad, N m s/rad].
  void spring_constants(StateVector& stiffness, StateVector& damping) const {
    springs_.constants(stiffness, damping);
  }
  void solve(const Factors& factors, const Evaluation& at, const StateVector& left, const StateVector& rows,
             const StateVector& slack, StateVector& x, StateVector& mu, StateVector& stretch) {
    give(left, rows);
    springs_.put_slack(slack, given_);
    matrix_.solve(factors, at->body(), given_, x, mu);
    springs_.stretch_of(factors.at().assembly, slack, matrix_.solution(), stretch);
  }
  // internal rows (displacements.hpp)
  void internal_residual(const Evaluation& at, const StateVector& v_dot, StateVector& left) const {
    displacements_.internal_residual(at->body(), v_dot, left);
  }
  void solve_internal_rows(const Evaluation& at, const StateVector& left, StateVector& x) const {
    displacements_.solve_internal_rows(at->body(), left, x);
  }

  long factorisations() const { return first_order_.factorisations() + newton_matrices(); }
  /// The number of factored Newton matrices.
  long newton_matrices() const { return matrix_.factorisations(); }

 private:
  void inertia_force(const std::vector<typename F::Reduced>& body, const StateVector& x,
                     StateVector& force) const {
    force.resize(velocity_size());
    for (int b = 0; b < nb(); ++b) {
      const RigidBody<S>& of_body = mechanism_.bodies[b];
      Layout::of(force, b) << of_body.mass * Layout::r_of(x, b),
          F::mass_block(body[b], of_body.inertia) * Layout::q_of(x, b);
    }
  }
  EffectView<S> view(const EvaluatedModel<F>& model) {
    std::copy(model.body().begin(), model.body().end(), motion_.begin());
    return {mechanism_.bodies, motion_, model.t};
  }
  void apply_effects(const EvaluatedModel<F>& model) {
    for (Wrench<S>& w : wrenches_) w = {};
    mechanism_.effects.apply(view(model), wrenches_);
  }
  /// Assembles rows and mass blocks, once per evaluation. Factors keep using these rows and blocks, so that
  /// an evaluation that has been factored must not be assembled again.
  void assemble(EvaluatedModel<F>& model) {
    if (model.is_factored)
      throw std::logic_error("residuals or factors are requested from an evaluation that has been factored");
    if (std::exchange(model.is_assembled, true)) return;
    if (springs() > 0) springs_.evaluate(model.assembly, view(model), model.spring_sizes);
    matrix_.assemble(model.assembly, model.t);
  }
  void give(const StateVector& left, const StateVector& rows) {
    matrix_.put_reduced(left, given_);
    matrix_.put_rows(rows, given_);
  }

  /// Measures the rows in given_. Dependent rows are not solved for. Where they differ from a combination of
  /// the others, if only by the digits that a file leaves out, no iteration meets them; they count only if
  /// they are off by more than most_violation.
  template <class Measure>
  Violation without_dependent_rows(const Measure& measure) {
    const Violation all = measure();
    if (all.relative <= integrators::rounding<S>() || !(all.relative <= S(integrators::most_violation)))
      return all;
    for_each_dependent_row([&](int e, int k) { given_.edge[e][k] = S(0); });
    return measure();
  }
  /// Calls act(edge, k) with the rows that were dependent at the last accepted state.
  template <class Act>
  void for_each_dependent_row(const Act& act) {
    const GraphSolver<S>& solved = first_order_.solver().factors();
    const auto& edges = first_order_.solver().plan().graph.edges;
    for (int e = 0; e < static_cast<int>(edges.size()); ++e)
      for (int k = 0; k < edges[e].size(); ++k)
        if (solved.is_dependent(e, k)) act(e, k);
  }

  FirstOrderEquations<F> first_order_;
  const MechanismOf<F>& mechanism_;
  const Layout& layout_;
  const Displacements<F> displacements_;
  const std::shared_ptr<const EliminationPlan> plan_;  ///< shared by evaluations and factors
  const SpringRows<F> springs_;
  NewtonMatrix<F> matrix_;
  ForceBalance<F> balance_;
  const ConstraintViolation<S> violation_;  ///< prototype that every new evaluation copies
  GraphVector<S> given_;                    ///< scratch storage: a right side
  std::vector<BodyMotion<S>> motion_;
  std::vector<Wrench<S>> wrenches_;
};

}  // namespace trivium
