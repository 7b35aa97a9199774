#pragma once
/// A motion to be judged: its scene, its times, its steps, what is monitored. All methods of a family run it
/// in all formulations.

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "formulations/contract/chart_options.hpp"
#include "integrators/contract/tolerances.hpp"
#include "scenes/scene.hpp"
#include "simulation/motion.hpp"

namespace trivium::hard {

class Judge;
struct Row;

/// Which difference of two motions is monitored [-].
enum class Monitor {
  motion,     ///< positions, orientations, velocities and angular velocities
  positions,  ///< of the centres of mass
};

/// The branch of its motions on which a mechanism starts, and from which it may go over to another one at a
/// singular position.
struct Branch {
  std::string name;  ///< what holds on it; empty: no branch is said
  std::function<bool(const MechanismState<double>&)> holds = {};
};

/// The run that serves as exact motion: in double by a method of high order, for stiff scenes an implicit
/// one, or in quad.
enum class ReferenceRun { in_double, stiff, in_quad };

/// A run, for further rows about it.
struct RunOfCase {
  const Row& row;  ///< of the motion
  double factor;   ///< of its threshold
  const SimulationReport& report;
  double figure;  ///< the largest relative error that its warnings state; 0 without a warning
};

/// The standard tolerance of a simulation.
inline constexpr double standard_rtol = 1e-8;

/// A run of more steps is given up.
inline constexpr long most_steps = 5'000'000;

/// Keeps the outputs, and ends a run that takes more steps than `most`.
class LimitedSamples : public Samples {
 public:
  explicit LimitedSamples(long most) : most_(most) {}
  bool step(double) override { return ++steps_ < most_; }

 private:
  long most_, steps_ = 0;
};

/// At how many states, evenly spread, a motion is compared with the exact one.
inline constexpr int hard_outputs = 20;

struct HardMotion {
  scenes::Scene scene;
  double start = 0, end = 1;  ///< times [s]
  double step = 1e-3;  ///< of methods with given steps, or a little less, so that it divides the run [s]
  Monitor monitor = Monitor::motion;
  /// Sets the bodies' state at the state's time, if a formula is known.
  std::function<void(MechanismState<double>&)> exact = {};
  ReferenceRun reference = ReferenceRun::in_double;
  ChartOptions charts = {};
  /// The length [m] to which differences and the absolute tolerance refer; 0: the mechanism's extent, and 1
  /// m.
  double length = 0;
  double speed = 0;  ///< of a slow motion [m/s], to which the absolute tolerance then refers; 0: fast enough
  double rounding = 0;          ///< errors that the numbers of the state allow, relative to `length` [-]
  double rtol = standard_rtol;  ///< of chosen steps
  bool chooses_steps = true;    ///< false: given steps only
  bool gives_steps = true;      ///< false: chosen steps only
  /// False: sums of local errors are far too small, as for steps over singular positions (docs/limits.md).
  /// Then what they may add up to without a warning counts.
  bool sums_hold = true;
  Branch branch = {};
  std::string reason = {};  ///< words that an error has to contain, if its reason is known; empty: any
  std::optional<double> max_step = {};    ///< the longest chosen step [s]
  int starts = hard_outputs;              ///< along the motion, where neighbours measure the amplification
  int directions = 1;                     ///< of the neighbours of each start
  std::vector<std::string> methods = {};  ///< if not those of the family
  bool beside_simbody = true;
  /// The tolerances of chosen steps: the absolute one is a hundredth of rtol, as a share of the length, or of
  /// the speed if this is the smaller number.
  integrators::Tolerances tolerances(double relative) const {
    const double scale = length > 0 ? length : 1;
    return {relative, relative / 100 * (speed > 0 ? std::min(scale, speed) : scale)};
  }
  /// What both allow a step, relative to the length [-].
  static double of_a_step(double relative) { return relative + relative / 100; }
  double of_a_step() const { return of_a_step(rtol); }
  std::function<void(Judge&, const RunOfCase&)> also = {};  ///< adds rows about what else a run must satisfy
};

}  // namespace trivium::hard
