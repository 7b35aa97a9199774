#pragma once
/// A method walks a system through a grid of times. The walk decides that a step is taken again, shorter:
/// where its projection fails, where the system says that projection_is_too_large (a step that would leave
/// its branch; the threshold is the system's), or where the step is longer than the system's longest_step
/// allows. By how much it is shortened is the method's (StepSizeControl::shorten). The walk stops before a
/// time where the model may jump, and has the system pass_discontinuity there. Where an iteration diverges
/// within a step is decided by the method.

#include <functional>

#include "integrators/contract/any_method.hpp"
#include "integrators/projection_iteration.hpp"
#include "integrators/time_grid.hpp"

namespace trivium::integrators {

/// Whether to go on after a step.
enum class Continue { yes, no };

/// Projects the start and after every step unless told not to, and shows `at_step(t, y)` every step and
/// `at_output(t, y)` the start, every output and the end, where it was told to stop or came to it. Returns
/// which: true at the end. Compiled once for each Scalar.
template <class S>
bool integrate(AnySystem<S>& system, AnyMethod<S>& method, const TimeGrid& grid, bool projects,
               ProjectionReport<S>& report,
               const std::function<Continue(const S& t, const StateVector<S>& y)>& at_step,
               const std::function<void(const S& t, const StateVector<S>& y)>& at_output);

}  // namespace trivium::integrators
