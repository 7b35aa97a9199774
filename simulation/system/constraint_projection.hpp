#pragma once
/// One linear correction of a state towards its constraints: the change x with the least x^T M x that
/// satisfies the linearised rows,
///
///     M x + Phi_q^T mu = 0,   Phi_q x = -Phi  (positions)   or   Phi_q x = -(Phi_q q' - nu)  (velocities)
///
/// integrators/projection_iteration.hpp repeats the correction and decides when the violation is small
/// enough.

#include <span>
#include <vector>

#include "formulations/structured/acceleration_solver.hpp"
#include "simulation/system/constraint_violation.hpp"
#include "simulation/system/state_layout.hpp"

namespace trivium {

/// Measures the violation of positions or velocities at a state, and corrects the positions or velocities of
/// y. The matrix is that of the acceleration solver.
template <Formulation F>
class ConstraintProjection {
 public:
  using S = typename F::Scalar;

  /// Uses the solver's matrix and factors, and the dependent rows that the solver found last. The solver must
  /// outlive this object. `t` is the start of the run [s], at which the scales of the rows are taken.
  ConstraintProjection(AccelerationSolver<F>& solver, const S& t)
      : solver_(solver),
        measure_(solver.mechanism(), solver.plan().graph, t),
        violation_(solver.plan().graph),
        change_(violation_) {}

  /// Moves the bodies to a state; the functions below refer to it.
  void move(std::span<const BodyState<F>> state, const S& t) {
    t_ = t;
    for (int b = 0; b < solver_.mechanism().nb(); ++b) solver_.assembly().move_body(b, state[b]);
    measure_.move(solver_.assembly().body());
  }
  /// Tells the measure that the motion has reached the state of the solver's bodies.
  void accept_state() {
    measure_.move(solver_.assembly().body());
    measure_.accept_state(solver_.mechanism().bodies, solver_.loads());
  }

  /// The violation of positions at the current state (constraint_violation.hpp).
  integrators::Violation<S> measure_positions() {
    solver_.assembly().positions(t_, violation_);
    return measure_.measure_positions(violation_);
  }
  /// The violation of velocities at the current state.
  integrators::Violation<S> measure_velocities() {
    solver_.assembly().velocities(t_, violation_);
    return measure_.measure_velocities(violation_);
  }
  /// The jump of the velocity residual Phi_q q' - nu between the time `before` and the state's time, at the
  /// same positions and velocities, caused by jumps of nu alone. solve() then uses it as its right side.
  integrators::Violation<S> measure_jump(const S& before) {
    solver_.assembly().velocities(before, change_);
    solver_.assembly().velocities(t_, violation_);
    for (std::size_t e = 0; e < violation_.edge.size(); ++e) violation_.edge[e] -= change_.edge[e];
    return measure_.measure_velocities(violation_);
  }
  const ConstraintViolation<S>& measure() const { return measure_; }
  ConstraintViolation<S>& measure() { return measure_; }

  /// Factors the matrix at the current state. Throws a ModelError that names a singular body.
  void factor() {
    GraphAssembly<F>& assembly = solver_.assembly();
    for (const auto& link : assembly.links()) assembly.assemble_link(link, t_, change_);
    assembly.assemble_closings(t_, change_);
    solver_.factors().set_dependent_rows(DependentRows::keep);
    ++factorisations_;
    try {
      solver_.factors().factor(assembly.matrix());
    } catch (const SingularLink& link) {
      throw solver_.named(link, t_);
    }
  }
  long factorisations() const { return factorisations_; }
  /// The change that removes the residual measured last, by the current factors.
  void solve() {
    for (Vector6<S>& row : violation_.edge) row = -row;
    solver_.factors().solve(violation_, change_);
  }
  /// Corrects the positions of y by the residual measured last; `state` must be the state of y. If `factors`,
  /// the matrix is factored at the current state first; otherwise the last factors are used.
  void correct_positions(const StateLayout<F>& layout, const std::vector<BodyState<F>>& state, VectorX<S>& y,
                         bool factors) {
    if (factors) factor();
    solve();
    for (int b = 0; b < layout.nb(); ++b) {
      layout.place(y, b) << state[b].r + r_change(b),
          F::retract(state[b].chart, layout.orientation(y, b), q_change(b));
    }
  }
  void correct_velocities(const StateLayout<F>& layout, const std::vector<BodyState<F>>& state, VectorX<S>& y,
                          bool factors) {
    if (factors) factor();
    solve();
    for (int b = 0; b < layout.nb(); ++b) {
      typename F::Unknown v = layout.velocity(y, b) + q_change(b);
      layout.rate(y, b) << state[b].r_dot + r_change(b), v;
    }
  }
  /// The multipliers mu of the last change, in the order of the mechanism's rows.
  void copy_multipliers(VectorX<S>& mu) const {
    const auto& edges = solver_.plan().graph.edges;
    for (std::size_t e = 0; e < edges.size(); ++e)
      for (int k = 0; k < edges[e].size(); ++k) mu[edges[e].rows[k]] = change_.edge[e][k];
  }
  Vector3<S> r_change(int b) const { return unpadded<S>(change_.body[b].r); }
  typename F::Unknown q_change(int b) const {
    return F::increment(solver_.assembly().body()[b], unpadded<S>(change_.body[b].x));
  }

 private:
  AccelerationSolver<F>& solver_;
  ConstraintViolation<S> measure_;
  GraphVector<S> violation_, change_;
  S t_{0};
  long factorisations_ = 0;
};

}  // namespace trivium
