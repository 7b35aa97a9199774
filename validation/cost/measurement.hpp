#pragma once
/// All engines on one scene: what each takes, and how exact it is. Engines are timed in turn, in random order
/// (timing.hpp); errors are distances from the solution in quad.

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
  std::string engine, formulation, refinement;  ///< the last two empty where they are ours alone
  std::optional<double> microseconds;           ///< none: `note` says why
  std::optional<double> ratio;                  ///< to r-omega, refined
  std::optional<double> error, lambda_error;
  std::optional<double> kilobytes;  ///< on the heap, scene and all, after an evaluation
  std::string note;
  bool failed = false;  ///< the engine tried and could not
  bool ours = false;

  double microseconds_per_body() const { return *microseconds / bodies; }
};

inline constexpr const char* our_name = "Trivium";

/// The row as one of ours.
Measurement of_ours(Measurement row, const std::string& formulation, Refined refined);

/// An engine that needs more than this for one evaluation is not timed.
inline constexpr double most_seconds = 2;

std::vector<Measurement> measure(const TimedScene& scene, const Timing& timing);

/// Sets every ratio from the time of r-omega, refined, if that is there.
void set_ratios(std::vector<Measurement>& rows);

}  // namespace trivium::cost
