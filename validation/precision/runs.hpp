#pragma once
/// What accuracy costs: a scene's motion by many methods at many tolerances or steps, ours and Simbody's.
/// Each run has its errors against one reference and the CPU time that it takes; decided here are the
/// tolerances and steps.

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "integrators/method_parameters.hpp"
#include "simulation/motion.hpp"
#include "validation/harness/named_scene.hpp"

namespace trivium::precision {

struct TimedMotion : NamedScene {
  TimedMotion(NamedScene named, double end) : NamedScene(std::move(named)), t_end(end) {}
  double t_end;
};

/// A method with one tolerance or step.
struct RunSettings {
  std::string engine, formulation, method;  ///< no formulation: a peer's own coordinates
  std::optional<double> rtol, step;
  integrators::MethodParameters parameters = {};

  std::string setting() const;
};

/// Largest over all bodies and outputs. Reactions, drift and energy of ours alone.
struct MotionErrors {
  double position = 0;             ///< [m]
  double orientation = 0;          ///< the angle between [rad]
  double velocity = 0;             ///< [m/s], and [rad/s]
  std::optional<double> reaction;  ///< [N]
  std::optional<double> drift;     ///< of Phi [m, rad]
  std::optional<double> energy;    ///< not accounted for [J]
};

/// CPU seconds of this thread over repetitions.
struct Seconds {
  double least = 0, median = 0;
  double low = 0, high = 0;  ///< the median's confidence interval (see confidence)
};

struct RunResult {
  RunSettings settings;
  std::string failure;  ///< empty where it came to the end
  MotionErrors errors;
  Seconds seconds;
  long steps = 0, evaluations = 0, factorisations = 0;

  bool solved() const { return failure.empty(); }
};

/// A motion's states (and ours' reactions) at the outputs.
struct ReferenceMotion {
  std::vector<MotionSample> samples;
  /// [m], or [rad] where trusted numbers are angles: the most that another method at a tighter tolerance or
  /// trusted numbers make of it.
  double own_error = 0;
  bool is_trusted = false;  ///< whether there are any
};

/// Every output time but the start's.
std::vector<double> output_times(const TimedMotion& motion);

/// By Fehlberg's method in quad, confirmed by Bulirsch and Stoer's, and by trusted numbers where there are
/// any.
ReferenceMotion reference_of(const TimedMotion& motion);

/// How far [m, or rad of orientations] samples of a scene's motion are from trusted numbers
/// (validation/reference/) at the times of both; nothing where there are none.
std::optional<double> apart_from_trusted(const std::string& scene, const std::vector<MotionSample>& samples);

/// What methods that choose their steps are run with.
std::vector<double> tolerances(bool quick);
/// Where doubles end: of those methods alone whose order makes it affordable, and of peers.
inline constexpr std::array finest_tolerances{1e-12, 1e-13};

/// Ours in three formulations, and Simbody's where it is there.
std::vector<RunSettings> all_settings(bool quick);

/// The errors of each, once; then how long each takes, all in turn and in random order.
std::vector<RunResult> measure_runs(const TimedMotion& motion, const ReferenceMotion& reference,
                                    const std::vector<RunSettings>& all, int repetitions,
                                    const std::function<void()>& step);

/// The chance [-] that the median of endless repetitions lies between the second least and second largest of
/// so many (the least and the largest where there are fewer than 5).
double confidence(int repetitions);

// Simbody's part; where it was not there when this was built, it has no settings
std::vector<RunSettings> peer_settings(bool quick);
struct PeerMotion {
  std::vector<MechanismState<double>> states;
  double seconds = 0;
  long steps = 0, evaluations = 0;
};
/// Throws a std::runtime_error.
PeerMotion peer_motion(const TimedMotion& motion, const RunSettings& settings);

}  // namespace trivium::precision
