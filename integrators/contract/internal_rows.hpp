#pragma once
/// Rows that a model keeps to itself, such as |p| = 1: they have no multiplier that a method could see, and
/// are met beside the others. A model without any does nothing here.

#include <concepts>

#include "integrators/contract/residual.hpp"

namespace trivium::integrators {

///   normalise_step       from (share, y, v'): meets the rows by a change of v', which moves q by `share` of
///                        it, and moves y's positions there. Returns whether there are any
///   normalise_step_velocity
///                        from (share, y, v'): the same for their derivatives, by a change of v' that moves v
///
/// For methods whose steps have no place for a normalisation:
///
///   internal_residual    from (at, v', left): what v' leaves of the rows' second derivatives, into the
///                        places that `residual` leaves at 0
///   solve_internal_rows  from (at, left, x): adds to x what removes that
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
