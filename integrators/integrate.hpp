#pragma once
/// A method walks a system through a grid of times. Who decides what:
///
///   that a finished step is taken back and a shorter one taken: checked_step (integrate.cpp), where the
///   projection fails, where the system finds that projection_is_too_large (the step may have left its
///   branch; the threshold is the system's, in simulation/system/branch_check.hpp), or where the
///   step turned out more than twice as long as the system's longest_step
///
///   by how much it is shortened: the method (StepSizeControl::shorten); methods of given steps refuse, which
///   ends the run
///
///   that an iteration within a step diverges: the method
///
///   that a discontinuity is passed: integrate, which stops just before its time and has the system
///   pass_discontinuity there; the method restarts

#include <functional>

#include "integrators/contract/any_method.hpp"
#include "integrators/projection_iteration.hpp"
#include "integrators/time_grid.hpp"

namespace trivium::integrators {

/// Whether to go on after a step.
enum class Continue { yes, no };

/// Projects the start and after every step unless told not to, and shows `at_step(t, y)` every step and
/// `at_output(t, y)` the start, every output and the end, where it was told to stop or came to it. A grid
/// that goes on has its start projected already. Returns which: true at the end. Compiled once for each
/// Scalar.
template <class S>
bool integrate(AnySystem<S>& system, AnyMethod<S>& method, const TimeGrid& grid, bool projects,
               ProjectionReport<S>& report,
               const std::function<Continue(const S& t, const StateVector<S>& y)>& at_step,
               const std::function<Continue(const S& t, const StateVector<S>& y)>& at_output);

}  // namespace trivium::integrators
