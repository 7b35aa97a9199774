#pragma once
/// Runs the motion of a scene by many methods at many tolerances or step sizes, with Trivium and with
/// Simbody. Each run gets its errors relative to one reference, and its CPU time. This file also decides the
/// tolerances and step sizes.

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

/// A method with one tolerance or one step size.
struct RunSettings {
  std::string engine, formulation, method;  ///< no formulation: another engine and its coordinates
  std::optional<double> rtol, step;
  integrators::MethodParameters parameters = {};

  std::string setting() const;
};

/// The largest errors over all bodies and outputs. Reactions, drift and energy are known for Trivium only.
struct MotionErrors {
  double position = 0;             ///< [m]
  double orientation = 0;          ///< angle between found and exact orientation [rad]
  double velocity = 0;             ///< of r_dot [m/s] and omega_bar [rad/s]
  std::optional<double> reaction;  ///< force of a joint [N]
  std::optional<double> drift;     ///< constraint violation Phi [m, rad]
  std::optional<double> energy;    ///< change of energy that work does not explain [J]
};

/// CPU times [s] of this thread over the repetitions of one run.
struct Seconds {
  double least = 0, median = 0;
  double low = 0, high = 0;  ///< confidence interval of the median (see confidence())
};

struct RunResult {
  RunSettings settings;
  std::string failure;  ///< error message; empty if the run reached its end
  MotionErrors errors;
  Seconds seconds;
  long steps = 0, evaluations = 0, factorisations = 0;

  bool solved() const { return failure.empty(); }
};

/// The reference: states at all outputs, with Trivium's reactions.
struct ReferenceMotion {
  std::vector<MotionSample> samples;
  /// Estimated error [m, or rad if trusted numbers are angles]: the largest difference from the solution of
  /// another method or from trusted numbers.
  double own_error = 0;
  bool is_trusted = false;  ///< trusted numbers exist and were compared
};

/// All output times [s] except the start.
std::vector<double> output_times(const TimedMotion& motion);

/// The reference by Bulirsch-Stoer in quad. Its error is estimated from a solution by Fehlberg's method in
/// quad, and from trusted numbers if there are any.
ReferenceMotion reference_of(const TimedMotion& motion);

/// The largest difference [m, or rad for orientations] between samples of a scene's motion and trusted
/// numbers (validation/reference/) at common times; empty if there are no trusted numbers.
std::optional<double> apart_from_trusted(const std::string& scene, const std::vector<MotionSample>& samples);

/// The relative tolerances of methods that choose their steps; atol is a hundredth of each.
std::vector<double> tolerances(bool quick);
/// Tolerances near the accuracy of double: used only for peers, and for methods whose order keeps the number
/// of steps small.
inline constexpr std::array finest_tolerances{1e-12, 1e-13};

/// The settings of all runs: Trivium in the timed formulations, and Simbody if it is installed.
std::vector<RunSettings> all_settings(bool quick);

/// Computes the errors of each run once; then measures the CPU times of all runs, repeated in random order.
std::vector<RunResult> measure_runs(const TimedMotion& motion, const ReferenceMotion& reference,
                                    const std::vector<RunSettings>& all, int repetitions,
                                    const std::function<void()>& step);

/// The probability [-] that the true median lies between the second smallest and second largest of the
/// repetitions (between the smallest and the largest if there are fewer than 5).
double confidence(int repetitions);

// Simbody's runs; without Simbody, peer_settings is empty
std::vector<RunSettings> peer_settings(bool quick);
struct PeerMotion {
  std::vector<MechanismState<double>> states;
  double seconds = 0;
  long steps = 0, evaluations = 0;
};
/// Runs the motion with Simbody. Throws a std::runtime_error if the run fails.
PeerMotion peer_motion(const TimedMotion& motion, const RunSettings& settings);

}  // namespace trivium::precision
