#pragma once
/// Charts for the callers of a formulation: the options that a caller can set, and the chart type of a
/// formulation without charts. euler_chart_choice.hpp chooses the chart of each body.

#include <string_view>

#include "bodies/rotations/euler_sequence.hpp"

namespace trivium {

/// Options for the choice of charts; formulations without charts ignore them.
struct ChartOptions {
  EulerSequence sequence;  ///< 3-1-3 by default
  bool reframe = true;     ///< exchange the Euler angles of a body near their singularity (docs/charts.md)
};

/// The chart of a formulation without charts: it has no data and an empty name.
struct NoChart {
  std::string_view name() const { return {}; }
};
/// Reads a chart from its name; returns false if no chart has this name. A run that continues from a saved
/// state calls this function; with a chart type that lacks it no run can be continued.
inline bool read_chart(std::string_view name, NoChart&) { return name.empty(); }

}  // namespace trivium
