#pragma once
/// The record of all projections of a run (integrators/projection_iteration.hpp): violations before and
/// after. Reports print it, and warn if the violation after projections is too large.

namespace trivium::integrators {

/// The largest violations of a row before and after (`_left`) projections [m or rad, m/s or rad/s], and the
/// number of Newton corrections of all projections.
template <class S>
struct ProjectionReport {
  S position{0}, velocity{0};
  S position_left{0}, velocity_left{0};
  long changes = 0;
};

}  // namespace trivium::integrators
