#pragma once
/// Internal rows are constraints that a model handles itself, such as |p| = 1. Their multipliers do not
/// belong to lambda, and methods satisfy them through the functions below. For a model without internal rows
/// these functions do nothing.

#include <concepts>

#include "integrators/contract/residual.hpp"

namespace trivium::integrators {

///   normalise_step       from (share, y, v'): moves the positions of y onto the internal rows, and changes
///                        v' accordingly: a change of v' moves q by `share` times the change. Returns whether
///                        the model has internal rows
///   normalise_step_velocity
///                        from (share, y, v'): the same for the derivatives of the rows: changes v' so that
///                        v, which moves by `share` times the change, satisfies them
///
/// For methods whose steps do not normalise:
///
///   internal_residual    from (at, v', left): the residual of the rows' second derivatives for this v', put
///                        into the elements of `left` that `residual` leaves 0
///   solve_internal_rows  from (at, left, x): adds to x the smallest change of v' that makes this residual
///                        zero
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
