#pragma once
/// The equations of motion with multipliers, and their residual for a state and an estimate of v' and lambda:
///
///   M(q) v' + Phi_q^T lambda = Q(q, v, t),   Phi(q, t) = 0,   Phi_q v = nu
///
/// An evaluation is the model at one (t, y), as a value. The functions below take an evaluation, and their
/// results do not depend on which evaluation was made last.

#include <concepts>
#include <string>

#include "integrators/contract/displacements.hpp"

namespace trivium::integrators {

///   Evaluation           empty at first; the next `evaluate` uses its storage again
///   evaluate             from (t, y, at): makes `at` the model at (t, y)
///   multipliers          the number of elements of lambda
///   accelerations        from (t, y, v', lambda): solves the equations of index 1 (constraints
///                        differentiated twice) for v' and lambda
///
/// Generalised forces, with as many elements as v:
///
///   inertia_is_constant  whether M does not depend on q
///   inertia_force        from (at, x, force): M x
///   applied_force        from (at, force): the forces of the effects, without gyroscopic terms
///
/// Residuals of the equations and of the rows. The returned measures do not depend on the coordinates:
///
///   residual             from (at, force, lambda, left): Q - force - Phi_q^T lambda, where `force` stands
///                        for M v'. Returns the largest imbalance relative to the forces at work [-]. `left`
///                        is the reduced residual, from which the multipliers of the internal rows have been
///                        eliminated. It has fewer numbers than v, one less for each internal row. The vector
///                        keeps the length of v, and its unused elements are 0; internal_residual fills them
///                        (internal_rows.hpp)
///   position_rows, velocity_rows
///                        from (at, rows): Phi, and Phi_q v - nu. Each returns its Violation
///   clear_dependent      from (lambda): sets the multipliers of dependent rows to 0. A solution with
///                        factors does not change them, and the other rows take over
///                        their forces
///   work_rate            from (at, lambda): the rate [W] of the work, which is the element of y after q and
///                        v
template <class System>
concept HasResidual = HasDisplacements<System> && std::default_initializable<typename System::Evaluation> &&
    std::movable<typename System::Evaluation> &&
    requires(System& system, const typename System::Scalar& t, const StateVector<typename System::Scalar>& y,
             const StateVector<typename System::Scalar>& v, typename System::Evaluation& placed,
             const typename System::Evaluation& at, StateVector<typename System::Scalar>& changed, int row) {
  system.evaluate(t, y, placed);
  { system.multipliers() } -> std::convertible_to<int>;
  system.accelerations(t, y, changed, changed);
  { system.inertia_is_constant() } -> std::same_as<bool>;
  system.inertia_force(at, v, changed);
  system.applied_force(at, changed);
  { system.residual(at, v, v, changed) } -> std::convertible_to<typename System::Scalar>;
  { system.position_rows(at, changed) } -> std::same_as<Violation<typename System::Scalar>>;
  { system.velocity_rows(at, changed) } -> std::same_as<Violation<typename System::Scalar>>;
  system.clear_dependent(changed);
  { system.work_rate(at, v) } -> std::convertible_to<typename System::Scalar>;
};

}  // namespace trivium::integrators
