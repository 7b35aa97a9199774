#pragma once
/// The integration of a system over a time grid by a method. Each decision is made in one place:
///
///   Whether a finished step is taken back and repeated shorter: checked_step (integrate.cpp). It does so if
///   the state is not finite, if the projection fails, if projection_is_too_large holds, or if the step
///   turned out more than twice as long as the system's longest_step at its end. After a projection that is
///   too large, the step may have left its branch; the threshold is the system's
///   (simulation/system/branch_check.hpp).
///
///   The new, shorter step size: the method (StepSizeControl::shorten). Methods that take given steps refuse
///   to shorten, which ends the run.
///
///   Whether an iteration within a step diverges: the method.
///
///   What happens at a discontinuity: integrate, which stops just before its time, calls pass_discontinuity
///   of the system and restarts the method.

#include <functional>

#include "integrators/contract/any_method.hpp"
#include "integrators/projection_iteration.hpp"
#include "integrators/time_grid.hpp"

namespace trivium::integrators {

/// The answer of a callback: whether the integration goes on.
enum class Continue { yes, no };

/// Integrates over the grid. If `projects`, the start of the run, the end of every step and interpolated
/// outputs are projected onto the constraints. A run that continues an earlier one (TimeGrid::goes_on) starts
/// from a state that the earlier run has projected already; this state is not projected again. `at_step` is
/// called after every step, and after every event, where the motion begins anew; `at_output` at the start, at
/// every output, at the end, and where a callback stops the run or a step fails. Returns true if the run came
/// to the end of the grid. Compiled once per Scalar.
template <class S>
bool integrate(AnySystem<S>& system, AnyMethod<S>& method, const TimeGrid& grid, bool projects,
               ProjectionReport<S>& report,
               const std::function<Continue(const S& t, const StateVector<S>& y)>& at_step,
               const std::function<Continue(const S& t, const StateVector<S>& y)>& at_output);

}  // namespace trivium::integrators
