#pragma once
/// Internal rows are constraints that a model handles itself, such as |p| = 1. Their multipliers do not
/// belong to lambda, and methods satisfy them through the functions below. For a model without internal rows
/// these functions do nothing.

#include <concepts>

#include "integrators/contract/residual.hpp"

namespace trivium::integrators {

///   normalise_step       from (share, y, v'): moves the positions of y by the smallest displacement d that
///                        satisfies the internal rows, and adds d / share to v'. `share` is dq/dv' [s^2], the
///                        derivative of the positions by v' within the step. Returns whether the model has
///                        internal rows
///   normalise_step_velocity
///                        from (share, y, v'): adds to v' the smallest change c such that the velocities v +
///                        share c satisfy the time derivatives of the internal rows; y does not change.
///                        `share` is dv/dv' [s]
///
/// For methods whose steps do not normalise:
///
///   internal_residual    from (at, v', left): computes the residual gamma - P v' of the internal rows,
///                        differentiated twice by time, where P is their Jacobian. Puts it into the elements
///                        of `left` that `residual` has set to 0. The other elements keep the residual of the
///                        forces
///   solve_internal_rows  from (at, left, x): adds to x the smallest change c of v' with P c = gamma - P v',
///                        so that the residual becomes 0
template <class System>
concept HasInternalRows = HasResidual<System> &&
    requires(System& system, const typename System::Scalar& share, const typename System::Evaluation& at,
             const StateVector<typename System::Scalar>& v, StateVector<typename System::Scalar>& changed) {
  { system.normalise_step(share, changed, changed) } -> std::same_as<bool>;
  system.normalise_step_velocity(share, v, changed);
  system.internal_residual(at, v, changed);
  system.solve_internal_rows(at, v, changed);
};

}  // namespace trivium::integrators
