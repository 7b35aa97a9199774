#pragma once
/// The account of all projections of a run (integrators/projection_iteration.hpp): what they found, what they
/// left. Reports show it, and warn where too much is left.

namespace trivium::integrators {

/// What projections found and left: the largest violations, and how many changes they made.
template <class S>
struct ProjectionReport {
  S position{0}, velocity{0};
  S position_left{0}, velocity_left{0};
  long changes = 0;
};

}  // namespace trivium::integrators
