#pragma once
/// The equations of motion of one formulation with their constraints, for implicit methods:
///
///   M(q) v' + Phi_q^T lambda = Q(q, v, t),   Phi(q, t) = 0
///
/// in the same y = (q, v, work) as the equations of first order, which this owns. Residuals are in the
/// reduced unknowns (three of rotation a body: r-p's internal row is met by `normalise_step`), and so is
/// Newton's system
///
///   [ M + gamma' C + beta' K   Phi_q^T ] [ dv'     ]     [ M v' + Phi_q^T lambda - Q ]
///   [ Phi_q                    0       ] [ dlambda ] = - [ Phi / beta'               ]
///
/// where q moves with v' by beta' and v by gamma'. With its rows scaled so, its condition does not grow as
/// the steps get small. K and C are those of springs and dampers along their own directions
/// (spring_rows.hpp); what gyroscopic and geometric terms would add is left to the iteration, which falls by
/// about the angle that bodies turn in a step.
///
/// Models integrators' ConstrainedSystem.

#include <algorithm>
#include <string>
#include <vector>

#include "simulation/system/displacements.hpp"
#include "simulation/system/first_order_equations.hpp"
#include "simulation/system/force_balance.hpp"
#include "simulation/system/newton_matrix.hpp"
#include "simulation/system/spring_rows.hpp"

namespace trivium {

template <Formulation F>
class ConstrainedEquations {
 public:
  using Scalar = typename F::Scalar;
  using S = Scalar;
  using StateVector = VectorX<S>;
  using Layout = StateLayout<F>;

  /// Throws a ModelError that names the body whose chart is singular.
  ConstrainedEquations(const Mechanism<S>& mechanism, const MechanismState<S>& start,
                       const FirstOrderOptions& options = {})
      : first_order_(mechanism, start, options),
        mechanism_(first_order_.mechanism()),
        layout_(first_order_.layout()),
        displacements_(layout_, first_order_.state()),
        plan_(plan_elimination(graph_with_springs(mechanism_))),
        springs_(mechanism_, plan_),
        matrix_(mechanism_, plan_),
        balance_(mechanism_, plan_),
        violation_(mechanism_, plan_.graph, start.t),
        right_side_(plan_.graph),
        rows_(right_side_),
        given_(right_side_),
        motion_(nb() + 1),
        wrenches_(nb() + 1) {}

  /// The same motion as y' = f(t, y): its energies, its state as poses and twists, what happened to it.
  FirstOrderEquations<F>& first_order() { return first_order_; }
  const FirstOrderEquations<F>& first_order() const { return first_order_; }
  int nb() const { return mechanism_.nb(); }

  // what a FirstOrderSystem has
  int size() const { return first_order_.size(); }
  const StateVector& start() const { return first_order_.start(); }
  void derivative(const S& t, const StateVector& y, StateVector& y_dot) {
    first_order_.derivative(t, y, y_dot);
  }
  S position_violation(const S& t, const StateVector& y) { return first_order_.position_violation(t, y); }
  S velocity_violation(const S& t, const StateVector& y) { return first_order_.velocity_violation(t, y); }
  const S& relative_violation() const { return first_order_.relative_violation(); }
  bool projection_is_too_large(const StateVector& before, const StateVector& stepped,
                               const StateVector& projected) {
    return first_order_.projection_is_too_large(before, stepped, projected);
  }
  S longest_step(const S& t, const StateVector& y) { return first_order_.longest_step(t, y); }
  void correct_positions(StateVector& y, bool factor) { first_order_.correct_positions(y, factor); }
  void correct_velocities(StateVector& y, bool factor) { first_order_.correct_velocities(y, factor); }
  void normalise(StateVector& y) const { first_order_.normalise(y); }
  const std::string& worst_row() const { return first_order_.worst_row(); }
  bool accept_state(const S& t, StateVector& y) { return first_order_.accept_state(t, y); }
  bool pass_discontinuity(const S& before, const S& t, StateVector& y) {
    return first_order_.pass_discontinuity(before, t, y);
  }
  std::string diagnose(const S& t, const StateVector& y) { return first_order_.diagnose(t, y); }

  // y = (q, v, work): how many numbers q and v have, and lambda
  int position_size() const { return layout_.position_size(); }
  int velocity_size() const { return layout_.velocity_size(); }
  int multipliers() const { return mechanism_.nc(); }

  /// v' and lambda of index 1. Throws a ModelError.
  void accelerations(const S& t, const StateVector& y, StateVector& v_dot, StateVector& lambda) {
    const AccelerationSolver<F>& solved = first_order_.solved(t, y);
    v_dot.resize(velocity_size());
    for (int b = 0; b < nb(); ++b) Layout::of(v_dot, b) << solved.r_ddot(b), solved.q_ddot(b);
    lambda.resize(multipliers());
    solved.copy_lambda(lambda);
  }

  // steps between states (displacements.hpp)
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

  /// Whether M does not depend on q.
  bool inertia_is_constant() const { return F::inertia_is_constant; }
  /// M(q) v' at y.
  void inertia_force(const StateVector& y, const StateVector& v_dot, StateVector& force) {
    if constexpr (!F::inertia_is_constant) first_order_.load(y);
    force.resize(velocity_size());
    for (int b = 0; b < nb(); ++b) {
      const RigidBody<S>& of_body = mechanism_.bodies[b];
      Layout::of(force, b) << of_body.mass * Layout::r_of(v_dot, b),
          F::mass_block(kinematics_of(first_order_.state()[b]), of_body.inertia) * Layout::q_of(v_dot, b);
    }
  }
  /// What effects do at y.
  void applied_force(const S& t, const StateVector& y, StateVector& force) {
    first_order_.load(y);
    move(t);
    apply_effects();
    force.resize(velocity_size());
    for (int b = 0; b < nb(); ++b)
      Layout::of(force, b) << wrenches_[b].F,
          F::applied_force(matrix_.evaluated().body()[b], wrenches_[b].n_bar);
  }
  /// Evaluations and matrices can be kept side by side, as those of several stages: all that follows is about
  /// the one of this number, until the next is selected.
  void select(int number) { matrix_.select(number); }
  /// Evaluates force + Phi_q^T lambda - Q, Phi and Phi_q at y, from where `newton` and `factor` take them;
  /// `force` is what stands in the place of M v'. Returns the largest imbalance of a body, as a share of the
  /// forces or moments on the bodies that it is connected with.
  S residual(const S& t, const StateVector& y, const StateVector& force, const StateVector& lambda) {
    first_order_.load(y);
    move(t);
    apply_effects();
    springs_.evaluate(matrix_.evaluated(), view());
    matrix_.assemble(t);
    measure_positions();
    return balance_.measure(matrix_.evaluated(), wrenches_, springs_, violation_, force, lambda, right_side_);
  }
  /// Phi at y alone, or Phi' where bodies were moved last, in the place of Phi; how large it is beside the
  /// lengths or speeds of what moves together.
  S position_rows(const S& t, const StateVector& y) {
    first_order_.load(y);
    move(t);
    return measure_positions();
  }
  S velocity_rows() {
    rows_.edge = right_side_.edge;
    matrix_.evaluated().velocities(t_, right_side_);
    violation_.measure_velocities(right_side_);
    return violation_.relative();
  }
  /// The largest |Phi_k| (or |Phi_k'|) of what was evaluated last, beside the lengths (or speeds) of what
  /// moves together; and of which row.
  const S& relative_row_violation() const { return violation_.relative(); }
  const std::string& least_met_row() const { return violation_.worst_row(); }
  /// Newton's matrix of what was balanced last. Throws a ModelError.
  void factor(const S& velocity_share, const S& position_share) {
    springs_.let_resist(matrix_.evaluated(), velocity_share, position_share);
    matrix_.factor(first_order_.solver(), t_);
  }
  /// What removes the imbalance and the rows' violation evaluated last, by the factors at hand: added to v'
  /// and lambda, where v' moves what the rows measure by `share`.
  void newton(const S& share, StateVector& v_dot, StateVector& lambda) {
    for (Vector6<S>& row : right_side_.edge) row /= -share;
    solve(right_side_, v_dot, &lambda);
  }
  /// M x + Phi_q^T mu = 0, Phi_q x = -Phi + share Phi' of what was evaluated last, velocity rows after
  /// positions: added to x. Where v' meets the velocity rows, it moves Phi by that share of them.
  void project(const S& share, StateVector& x) {
    for (std::size_t e = 0; e < rows_.edge.size(); ++e)
      rows_.edge[e] = share * right_side_.edge[e] - rows_.edge[e];
    solve(rows_, x, nullptr);
  }
  /// What was evaluated last, to solve for with others of its kind: the rows by number, and what the bodies'
  /// forces leave (reduced, in the places of velocities).
  void row_residual(StateVector& rows) const { matrix_.take_rows(right_side_, rows); }
  void force_residual(StateVector& left) const { matrix_.take_reduced(right_side_, left); }
  /// The same of a generalised force, where the matrix is.
  void take_force(const StateVector& force, StateVector& left) const { matrix_.reduce(force, left); }
  /// M x + Phi_q^T mu = left, Phi_q x = rows: added to x and mu.
  void solve(const StateVector& left, const StateVector& rows, StateVector& x, StateVector& mu) {
    give(left, rows);
    solve(given_, x, &mu);
  }
  /// The same where springs resist only what x stretches them by beyond a slack; and by how much it does
  /// stretch them.
  void solve(const StateVector& left, const StateVector& rows, const StateVector& slack, StateVector& x,
             StateVector& mu, StateVector& stretch) {
    give(left, rows);
    springs_.put_slack(slack, given_);
    matrix_.solve(given_, x, &mu);
    springs_.stretch_of(matrix_.factored(), slack, matrix_.solution(), stretch);
  }
  /// The same for a generalised force, and rows that ask nothing.
  void solve_force(const StateVector& force, StateVector& x, StateVector& mu) {
    matrix_.put_force(force, given_);
    for (Vector6<S>& rows : given_.edge) rows.setZero();
    solve(given_, x, &mu);
  }
  bool has_springs() const { return !springs_.empty(); }
  /// [N/m, N s/m], or of moments by angles [N m, N m s].
  void spring_constants(StateVector& stiffness, StateVector& damping) const {
    springs_.constants(stiffness, damping);
  }
  /// What v' leaves of the internal rows' second derivatives where bodies were loaded last, in the places of
  /// velocities that force_residual leaves at 0.
  void take_internal_rows(const StateVector& v_dot, StateVector& left) const {
    displacements_.internal_residual(v_dot, left);
  }
  /// Adds to x what removes that, by the least change of the unknowns.
  void solve_internal_rows(const StateVector& y, const StateVector& left, StateVector& x) {
    if constexpr (F::internal_constraints > 0) first_order_.load(y);
    displacements_.solve_internal_rows(left, x);
  }
  /// M x + Phi_q^T mu = force, Phi_q x = - the rows evaluated last: added to x and mu.
  void velocity_projection(const StateVector& force, StateVector& x, StateVector& mu) {
    matrix_.put_force(force, right_side_);
    newton(S(1), x, mu);
  }
  /// The rate of the work [W] where it was evaluated last.
  S work_rate(const StateVector& lambda) {
    take_motion();
    return first_order_.account().power(view(), matrix_.evaluated().body(), lambda);
  }

  long factorisations() const { return first_order_.factorisations() + newton_matrices(); }
  /// Newton's alone, each made anew.
  long newton_matrices() const { return matrix_.factorisations(); }

 private:
  /// To the state that is loaded.
  void move(const S& t) {
    matrix_.begin_evaluation();
    t_ = t;
    for (int b = 0; b < nb(); ++b) matrix_.evaluated().move_body(b, first_order_.state()[b]);
    violation_.move(matrix_.evaluated().body());
  }
  void take_motion() {
    const auto& body = matrix_.evaluated().body();
    std::copy(body.begin(), body.end(), motion_.begin());
  }
  EffectView<S> view() const { return {mechanism_.bodies, motion_, t_}; }
  void apply_effects() {
    take_motion();
    for (Wrench<S>& w : wrenches_) w = {};
    mechanism_.effects.apply(view(), wrenches_);
  }
  S measure_positions() {
    matrix_.evaluated().positions(t_, right_side_);
    violation_.measure_positions(right_side_);
    return violation_.relative();
  }
  void give(const StateVector& left, const StateVector& rows) {
    matrix_.put_reduced(left, given_);
    matrix_.put_rows(rows, given_);
  }
  void solve(GraphVector<S>& right_side, StateVector& x, StateVector* lambda) {
    springs_.clear_slack(right_side);
    matrix_.solve(right_side, x, lambda);
  }

  FirstOrderEquations<F> first_order_;
  const Mechanism<S>& mechanism_;
  const Layout& layout_;
  const Displacements<F> displacements_;
  const EliminationPlan plan_;
  SpringRows<F> springs_;
  NewtonMatrix<F> matrix_;
  ForceBalance<F> balance_;
  ConstraintViolation<S> violation_;
  GraphVector<S> right_side_, rows_, given_;  ///< the bodies of rows_ stay 0
  std::vector<BodyMotion<S>> motion_;
  std::vector<Wrench<S>> wrenches_;
  S t_{0};
};

}  // namespace trivium
