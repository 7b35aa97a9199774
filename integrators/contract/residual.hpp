#pragma once
/// The equations of motion with multipliers, and what a state and a guess of v' and lambda leave of them:
///
///   M(q) v' + Phi_q^T lambda = Q(q, v, t),   Phi(q, t) = 0,   Phi_q v = nu
///
/// An evaluation is the model at one (t, y), as a value: all that is asked at a state is asked of it, and
/// nothing depends on which one was made last.

#include <concepts>
#include <string>

#include "integrators/contract/displacements.hpp"

namespace trivium::integrators {

///   Evaluation           empty at first; its storage is used again by the next `evaluate`
///   evaluate             from (t, y, at): makes `at` the model at (t, y)
///   multipliers          how many numbers lambda has
///   accelerations        from (t, y, v', lambda): v' and lambda of index 1
///
/// Forces, of v's kind:
///
///   inertia_is_constant  whether M does not depend on q
///   inertia_force        from (at, x, force): M x
///   applied_force        from (at, force): what effects do; gyroscopic terms are not among it
///
/// What is left, of the equations and of the rows. All measures returned mean the same in all coordinates:
///
///   residual             from (at, force, lambda, left): Q - force - Phi_q^T lambda, where the force stands
///                        for M v'. Returns the largest imbalance beside the forces at work. `left` is
///                        reduced: in the places of v, without what internal rows take
///                        (internal_rows.hpp)
///   position_rows, velocity_rows
///                        from (at, rows): Phi, and Phi_q v - nu. Each returns its Violation
///   work_rate            from (at, lambda): by how much the work behind q and v grows
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
  { system.work_rate(at, v) } -> std::convertible_to<typename System::Scalar>;
};

}  // namespace trivium::integrators
