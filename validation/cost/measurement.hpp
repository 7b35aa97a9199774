#pragma once
/// Measures all engines on one scene: computing time and accuracy. Engines are timed in random order
/// (timing.hpp); errors are differences from the solution in quad.

#include <optional>
#include <string>
#include <vector>

#include "validation/cost/timed_scenes.hpp"
#include "validation/cost/timing.hpp"
#include "validation/cost/trivium_engines.hpp"

namespace trivium::cost {

struct Measurement {
  std::string scene, family;
  int n = 0, bodies = 0;
  /// Only Trivium and the sparse solvers have a formulation; only Trivium has a refinement.
  std::string engine, formulation, refinement;
  std::optional<double> microseconds;  ///< empty if not timed; `note` says why
  std::optional<double> ratio;         ///< ratio to r-omega refined [-]
  std::optional<double> error, lambda_error;
  std::optional<double> kilobytes;  ///< heap memory of scene and engine after one evaluation [KiB]
  std::string note;
  bool failed = false;  ///< the engine accepted the scene, but could not solve it
  bool ours = false;

  double microseconds_per_body() const { return *microseconds / bodies; }
};

inline constexpr const char* our_name = "Trivium";

/// The row, completed as a measurement of Trivium.
Measurement of_ours(Measurement row, const std::string& formulation, Refined refined);

/// An engine that needs more time [s] for one evaluation is not timed. 2 s is chosen by experiment.
inline constexpr double most_seconds = 2;

std::vector<Measurement> measure(const TimedScene& scene, const Timing& timing);

/// Sets the ratios of all rows to the time of r-omega refined. Without that row they stay empty.
void set_ratios(std::vector<Measurement>& rows);

}  // namespace trivium::cost
