#pragma once
/// What implicit and half-explicit methods ask of a model besides y' = f(t, y): its equations of motion with
/// multipliers,
///
///   M(q) v' + Phi_q^T lambda = Q(q, v, t),   Phi(q, t) = 0,
///
/// their residuals, and linear systems with Newton's matrix.

#include <concepts>
#include <string>

#include "integrators/contract/first_order_system.hpp"

namespace trivium::integrators {

/// y begins with q and v; what follows, if anything, is the work, which grows by `work_rate`. The unknowns of
/// a step are v' and lambda, and q and v move with v' by a position share and a velocity share (h^2 and h,
/// times numbers of the method).
///
///   position_size, velocity_size, multipliers
///                        how many numbers q, v and lambda have
///   accelerations        v' and lambda of index 1 at (t, y)
///   work_rate            of the system as evaluated last, with these multipliers
///
/// Positions move by displacements, which are of v's kind:
///
///   displace             sets y's positions to where a displacement leads from another's
///   displacement         the way from one y to another
///   displacement_rate    how a displacement grows with v
///   position_rate        how y's own numbers of positions grow with v
///   position_sizes       how large, number by number of a displacement, what it moves is: errors count
///                        relative to it
///
/// Rows that a model keeps to itself, such as |p| = 1:
///
///   normalise_step       meets them by a change of v' that moves q by `share` of it. Returns whether there
///                        are any
///   normalise_step_velocity
///                        the same for their derivatives
///   take_internal_rows   for libraries, which have no place for normalise_step: puts what v' leaves of the
///                        rows' second derivatives beside a force residual
///   solve_internal_rows  adds to x what removes that
///
/// Forces, in v's kind:
///
///   inertia_is_constant  whether M does not depend on q
///   inertia_force        M(q) times a vector of v's kind
///   applied_force        what effects do; gyroscopic terms are not among them
///
/// Evaluations. All measures returned are relative, and mean the same in all coordinates:
///
///   residual             evaluates force + Phi_q^T lambda - Q, where the force stands for M v', and Phi.
///                        Returns the largest imbalance beside the forces at work
///   relative_row_violation
///                        the largest violation of Phi (or Phi', see below) beside the model's numbers
///   position_rows        evaluates Phi alone
///   velocity_rows        puts Phi' in the place of Phi
///   least_met_row        the name of the row violated most
///   row_residual, force_residual
///                        the vectors evaluated last
///   take_force           makes a force residual of a force of v's kind
///
/// Newton's matrix, of M and the springs' stiffness and damping by their shares, and of Phi_q:
///
///   factor               of what was evaluated last; of M alone for shares of 0
///   newton               adds to v' and lambda what removes residual and rows
///   project              adds to x the least change that removes Phi less a share of Phi'
///   velocity_projection  adds to x and mu: M x + Phi_q^T mu = force, Phi_q x = -rows
///   solve                adds to x and mu: M x + Phi_q^T mu = left, Phi_q x = rows; and the same where
///                        springs resist what x stretches them by beyond a slack
///   solve_force          the same for a force of v's kind
///   has_springs          whether the matrix depends on the shares
///   spring_constants     by what stiffness and damping
///   select               which of several evaluations and matrices, kept side by side, all of these mean:
///                        methods of several stages have one for each
template <class System>
concept ConstrainedSystem = FirstOrderSystem<System> &&
    requires(System& system, const typename System::Scalar& t, const StateVector<typename System::Scalar>& y,
             const StateVector<typename System::Scalar>& v, StateVector<typename System::Scalar>& changed,
             StateVector<typename System::Scalar>& lambda, int index) {
  { system.position_size() } -> std::convertible_to<int>;
  { system.velocity_size() } -> std::convertible_to<int>;
  { system.multipliers() } -> std::convertible_to<int>;
  system.accelerations(t, y, changed, lambda);
  system.displace(y, v, changed);
  system.displacement(y, y, changed);
  system.displacement_rate(v, v, changed);
  system.position_rate(y, v, changed);
  system.position_sizes(y, changed);
  { system.normalise_step(t, changed, lambda) } -> std::same_as<bool>;
  system.normalise_step_velocity(t, y, changed);
  { system.inertia_is_constant() } -> std::same_as<bool>;
  system.inertia_force(y, v, changed);
  system.applied_force(t, y, changed);
  { system.residual(t, y, v, v) } -> std::convertible_to<typename System::Scalar>;
  { system.position_rows(t, y) } -> std::convertible_to<typename System::Scalar>;
  { system.velocity_rows() } -> std::convertible_to<typename System::Scalar>;
  { system.relative_row_violation() } -> std::convertible_to<typename System::Scalar>;
  { system.least_met_row() } -> std::convertible_to<std::string>;
  system.select(index);
  system.factor(t, t);
  system.newton(t, changed, lambda);
  system.project(t, changed);
  system.velocity_projection(v, changed, lambda);
  system.row_residual(changed);
  system.force_residual(changed);
  system.take_force(v, changed);
  system.solve(v, v, changed, lambda);
  system.solve(v, v, v, changed, lambda, changed);
  system.solve_force(v, changed, lambda);
  system.take_internal_rows(v, changed);
  system.solve_internal_rows(y, v, changed);
  { system.has_springs() } -> std::same_as<bool>;
  system.spring_constants(changed, lambda);
  { system.work_rate(v) } -> std::convertible_to<typename System::Scalar>;
};

}  // namespace trivium::integrators
