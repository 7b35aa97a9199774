#pragma once
/// A scene's motion in one formulation by one method: that of the program `trivium simulate`, with the same
/// checks and warnings. A motion is seen output by output, may be stopped, and goes on from where it ended.

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trivium/instant.hpp"

namespace trivium {

struct SimulateSettings {
  std::string formulation = "r-omega";
  std::string integrator = "dopri5";
  double end = 10;                  ///< [s]
  std::optional<double> step = {};  ///< steps of this length [s]; else the method chooses, to the tolerances
  std::optional<double> output_step = {};      ///< time between outputs [s]; else the start and the end
  double rtol = 1e-8, atol = 1e-10;            ///< of a step
  std::optional<int> order = {};               ///< of bdf and ARKODE's
  std::optional<double> rho = {}, alpha = {};  ///< of generalized-alpha, of hht
  bool full_newton = false;                    ///< a matrix for every iteration, of implicit methods
  bool projects = true;                        ///< after every step, back onto the constraints
  std::optional<std::array<double, 2>> baumgarte = {};  ///< alpha, beta [1/s], instead of projection
  std::string sequence = "313";                         ///< Euler angles of r-epsilon
  bool reframe = true;                                  ///< other charts near their singularity
  std::function<bool(double t)> at_step = {};           ///< asked after every step whether to go on
};

/// What is seen at an output.
struct Output : Instant {
  std::vector<double> own_lambda;  ///< the method's own; empty where it has none
  double energy = 0;               ///< kinetic and potential [J]
  double phi = 0, phi_dot = 0;     ///< largest violation of a row [m or rad, per second]
};

/// Returns whether to go on.
using Observer = std::function<bool(const Output&)>;

/// Velocities that jumped with a driver's.
struct Jump {
  double t = 0;
  std::vector<double> impulse;  ///< per row [N s, N m s]: the integral of its multiplier
};

struct Motion {
  std::string formulation, integrator;
  double reached = 0;           ///< [s]
  bool complete = false;        ///< it came to its end, not stopped before
  std::vector<Output> outputs;  ///< where there was no observer
  long steps = 0, rejected_steps = 0, right_sides = 0, newton_iterations = 0, factorisations = 0;
  int chart_changes = 0;
  double phi = 0, phi_dot = 0, normalisation = 0;  ///< the largest after any step
  double energy_start = 0, energy_end = 0;         ///< kinetic and potential [J]
  double work = 0;                                 ///< of drivers and of what is not stored [J]
  double unaccounted_energy = 0;                   ///< the largest change of energy that is not work [J]
  std::vector<double> singular_positions;          ///< passed, when [s]
  std::vector<Jump> jumps;
  double seconds = 0;  ///< of processor time
  std::vector<std::string> warnings;
  /// The scene where the motion ended: to simulate on and to write; to solve, where the method meets the rows
  /// of velocities, or once it is assembled.
  Scene end = Scene("end");
};

/// Throws an Error: of kind input where the state does not satisfy its constraints, or what is asked for does
/// not go together; of another where the motion cannot go on. What the observer saw until then it has.
///
/// A scene that is the end of a motion goes on in the same numbers if the formulation is the same: methods
/// that keep nothing from step to step take given steps as if there had been no end, bit for bit; others to
/// their tolerances.
Motion simulate(const Scene& scene, const SimulateSettings& settings = {}, const Observer& observer = {});

namespace integrators {
/// The names of the methods in time.
std::vector<std::string> method_names();
}  // namespace integrators

}  // namespace trivium
