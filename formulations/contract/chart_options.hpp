#pragma once
/// Charts as a formulation's caller sees them: what may be asked for, and the chart of a formulation that has
/// none. Which chart a body gets is decided in euler_chart_choice.hpp.

#include <string_view>

#include "bodies/rotations/euler_sequence.hpp"

namespace trivium {

/// What the caller may say about charts; only a formulation that has charts listens.
struct ChartOptions {
  EulerSequence sequence;  ///< default 3-1-3
  bool reframe = true;  ///< turn a body's reference frame where the sequence would stand near its singularity
};

/// Nothing to choose and nothing to store: the chart of a formulation without charts.
struct NoChart {
  std::string_view name() const { return {}; }
};
/// The chart of a name; returns whether there is one. A run that goes on from a saved state asks for it; a
/// chart that has no such function cannot be gone on in.
inline bool read_chart(std::string_view name, NoChart&) { return name.empty(); }

}  // namespace trivium
