#pragma once
/// The record of all projections of a run (integrators/projection_iteration.hpp): violations before and
/// after. Reports print it, and warn if the violation after projections is too large.

namespace trivium::integrators {

/// The largest violations before and after (`_left`) projections, and the number of corrections.
template <class S>
struct ProjectionReport {
  S position{0}, velocity{0};
  S position_left{0}, velocity_left{0};
  long changes = 0;
};

}  // namespace trivium::integrators
