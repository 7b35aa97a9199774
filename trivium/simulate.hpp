#pragma once
/// Simulation of a scene's motion in one formulation by one integrator, as in the program `trivium simulate`,
/// with the same checks and warnings. An observer receives every output and may stop the run. A run can
/// continue from the end of another one.

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trivium/instant.hpp"

namespace trivium {

/// Settings of a run. With `step` the method takes given steps, and the tolerances are not used; without it,
/// the method chooses its steps. Not every integrator supports both kinds of steps.
struct SimulateSettings {
  std::string formulation = "r-omega";  ///< one of formulation_names()
  std::string integrator = "dopri5";    ///< one of integrators::method_names()
  double end = 10;                      ///< end time [s]; the start is the time of the scene
  std::optional<double> step = {};      ///< constant step size [s]; none: the method controls its step size
  /// Longest chosen step [s], so that a short pulse between two states is not missed; not with `step`.
  std::optional<double> max_step = {};
  std::optional<double> output_step = {};  ///< time between outputs [s]; none: outputs at start and end
  /// Relative tolerance of chosen steps [-]. The error of a step in a number x of the state vector
  /// (positions, rotational coordinates and velocities of the formulation, in SI units) is measured in units
  /// of atol + rtol |x|. Implicit methods of the library, hem4 and rattle have other sizes |x| for
  /// positions (docs/simulating.md). How the errors of all numbers are combined depends on the method.
  double rtol = 1e-8;
  double atol = 1e-10;  ///< absolute tolerance of chosen steps, as in rtol [the unit of x]
  /// Order of the method [-]; none: its default. bdf 1 to 5, default 2; arkode-erk 2 to 6 or 8, default 5;
  /// arkode-dirk 2 to 5, default 5.
  std::optional<int> order = {};
  /// Spectral radius at infinity of generalized-alpha and generalized-alpha-gl2, 0 to 1, default 0.8 [-].
  /// generalized-alpha with chosen steps takes at most 0.95.
  std::optional<double> rho = {};
  /// Parameter of hht, -1/3 to 0, default -0.2; with chosen steps at most -0.05 [-].
  std::optional<double> alpha = {};
  /// Implicit methods except those of SUNDIALS: factor Newton's matrix in every iteration, instead of about
  /// once per step.
  bool full_newton = false;
  /// Whether states are projected onto the constraints after every step. False switches the projection off,
  /// so that constraint violations grow. False is an Error of kind input with methods that satisfy the
  /// position constraints by their own equations (generalized-alpha, generalized-alpha-gl2, hht, radau5,
  /// radau9, bdf, rattle, rattle4, ida), and with `baumgarte`: there is no projection to switch off.
  bool projects = true;
  /// alpha, beta [1/s], not negative: the accelerations satisfy Phi'' + 2 alpha Phi' + beta^2 Phi = 0, and no
  /// state is projected. Not for the methods named above, nor for hedop5 and hem4.
  std::optional<std::array<double, 2>> baumgarte = {};
  std::string sequence = "313";  ///< sequence of the Euler angles of r-epsilon
  bool reframe = true;           ///< change a chart of Euler angles near its singularity
  /// Called after every step, at time t [s]; false stops the run. Its exceptions pass through simulate().
  std::function<bool(double t)> at_step = {};
};

/// The state at an output time, with energy and constraint violations.
struct Output : Instant {
  /// Multipliers that the method itself computes, an approximation of `lambda` in the same units. Empty if
  /// the method has none, and where it has computed none yet: at the start, and after a restart (at a kink of
  /// a function of time, or when a chart is changed). In rows whose `lambda_is_unique` is false they need not
  /// equal `lambda`.
  std::vector<double> raw_lambda;
  double energy = 0;  ///< kinetic plus potential energy [J]; for its zero see Check
  /// Largest |Phi| of a row, divided by the scale of the row [m or rad]. The scale is |c| for cd, |a_i| for
  /// dp2, |a_i| |a_j| for dp1, 2 sqrt(f) for d with f at the start (of the first run, if runs are continued),
  /// twice the distance for the joint distance, and 1 for all other joints. RowCheck::position_violation is
  /// another measure.
  double phi = 0;
  double phi_dot = 0;  ///< largest |Phi'| of a row, divided by the scale of the row [m/s or rad/s]
};

/// Called at every output, with the state there; false ends the run. If the output lies within a step (CVODE,
/// IDA, rattle with tolerances), the run ends at the end of this step. The observer is called there once
/// more, also if at_step ends the run. Its exceptions pass through simulate().
using Observer = std::function<bool(const Output&)>;

/// A sudden change of velocities at time t: the function of time of a driver has a kink there, so that the
/// driver demands another velocity after t than before.
struct Jump {
  double t = 0;                 ///< time of the kink [s]
  std::vector<double> impulse;  ///< [nc]: integral of lambda over the jump [unit of lambda times s]
};

/// The result of a run.
struct Motion {
  std::string formulation;        ///< name of the formulation
  std::string integrator;         ///< name of the integrator
  double reached = 0;             ///< time reached [s]
  bool complete = false;          ///< the end was reached; false if the observer or at_step stopped the run
  std::vector<Output> outputs;    ///< all outputs; empty if an observer was given
  long steps = 0;                 ///< steps that were accepted
  long rejected_steps = 0;        ///< steps that were not accepted and tried again
  long right_sides = 0;           ///< evaluations of the equations of motion
  long newton_iterations = 0;     ///< iterations of Newton's method in implicit methods
  long factorisations = 0;        ///< factorisations of all matrices
  int chart_changes = 0;          ///< how often the chart of a body changed, all bodies together
  double phi = 0;                 ///< largest violation of a row after any step, as in Output [m or rad]
  double phi_dot = 0;             ///< the same for the velocities [m/s or rad/s]
  double normalisation = 0;       ///< in r-p: largest |p . p - 1| after any step [-]; otherwise 0
  double energy_start = 0;        ///< kinetic plus potential energy at the start [J], as in Output
  double energy_end = 0;          ///< kinetic plus potential energy at the end [J], as in Output
  double work = 0;                ///< work of drivers and of non-conservative effects [J]
  double unaccounted_energy = 0;  ///< largest |change of energy - work| after any step [J]
  std::vector<double> singular_positions;  ///< times of the singular positions that the motion passed [s]
  std::vector<Jump> jumps;                 ///< sudden changes of velocities, in time order
  double seconds = 0;                      ///< CPU time of the thread for the run [s]
  /// Rows for which the rank tolerance decides narrowly at the start, singular positions passed, energy lost,
  /// constraint drift, large local errors of given steps.
  std::vector<std::string> warnings;
  /// The scene at the end of the motion. It can be written to a file, and simulate() continues from it.
  /// solve() needs velocities that satisfy their rows: after a method that does not enforce them (index 3),
  /// call assemble() first.
  Scene end = Scene("end");
};

/// Simulates from the scene's state to settings.end. Throws an Error of kind input if the state violates its
/// constraints or if settings contradict each other; of kind model or integration if the motion cannot
/// continue. The observer has received the outputs before the error and the last state that was reached;
/// exceptions of the observer pass through.
///
/// If `scene` is the end of another motion in the same formulation, the run continues from the saved numbers
/// of that motion. One-step methods with given steps then give the same bits as a run without interruption;
/// multistep methods and chosen steps agree within their errors.
Motion simulate(const Scene& scene, const SimulateSettings& settings = {}, const Observer& observer = {});

namespace integrators {
/// The names of the integrators, as SimulateSettings::integrator accepts them. Throws no Error.
std::vector<std::string> method_names();
}  // namespace integrators

}  // namespace trivium
