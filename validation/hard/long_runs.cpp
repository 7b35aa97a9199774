/// Long runs of a pendulum and of a slider-crank: energy, constraints and phase over many periods, and steps
/// so short that rounding shows.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "base/raise.hpp"
#include "bodies/numbers/scalar.hpp"
#include "integrators/contract/tolerances.hpp"
#include "scenes/building.hpp"
#include "scenes/make_mechanism.hpp"
#include "simulation/neighbouring_start.hpp"
#include "simulation/simulate.hpp"
#include "validation/hard/factors.hpp"
#include "validation/hard/family.hpp"
#include "validation/hard/known_motions.hpp"
#include "validation/hard/methods.hpp"

namespace trivium::hard {

namespace {

constexpr double arm = 1, moment = 0.1, mass = 1, g = 9.81, swing = 1;  // [m, kg m^2, kg, m/s^2, rad]

/// A pendulum about the y axis, released at rest, one radian from the vertical.
scenes::Scene pendulum() {
  scenes::Scene scene;
  scene.name = "pendulum";
  const scenes::Vector3 y{0, 1, 0};
  scene.bodies = {building::body("bob", mass, {moment, moment, moment},
                                 {-arm * std::sin(swing), 0, -arm * std::cos(swing)})};
  // the body's x axis points to the pivot: its z axis stays away from the vertical, where 3-1-3 is singular
  scene.bodies[0].orientation = scenes::AxisAngle{y, swing - std::numbers::pi / 2};
  scene.constraints = {building::joint(JointType::revolute, "pivot",
                                       building::side(scenes::ground, scenes::Vector3{}, y),
                                       building::side(0, scenes::Vector3{arm, 0, 0}, y))};
  scene.effects = {building::gravity(g)};
  return scene;
}

/// A motion that returns to its start.
struct Recurrence {
  scenes::Scene scene;
  double period;          ///< [s]
  double size, energies;  ///< of the motion, to which rounding errors are relative [m, J]
  long steps;             ///< of radau9 in a period
  /// How far a state is behind the start or ahead of it, as an angle but for full turns [rad].
  double (*phase)(const MechanismState<double>& start, const MechanismState<double>& state);
};

Recurrence swinging() {
  const double rate = std::sqrt((moment + mass * arm * arm) / (mass * g * arm));
  return {pendulum(), 4 * complete_elliptic_integral(std::cos(swing / 2)) * rate, arm, mass * g * arm, 20,
          // in the plane of the angle and its rate
          [](const MechanismState<double>&, const MechanismState<double>& state) {
            const double angle = std::atan2(-state.pose[0].r[0], -state.pose[0].r[2]);
            return std::atan2(-state.twist[0].omega_bar[1] / std::sqrt(g / arm), angle);
          }};
}

Recurrence turning() {
  return {slider_crank(),
          period_of_slider_crank(),
          1,
          1,
          60,
          [](const MechanismState<double>& start, const MechanismState<double>& state) {
            const auto angle = [](const MechanismState<double>& at) {
              return std::atan2(at.pose[0].r[1], at.pose[0].r[0]);
            };
            return angle(state) - angle(start);
          }};
}

/// A method in one formulation, with its steps in a period, and for how many periods the law of its phase
/// error holds; 0: always.
struct Kept {
  std::string method, formulation;
  long steps, in_phase;
  bool is_symplectic;
  std::string name() const { return fmt::format("{}, h = T/{}", method, steps); }
};

/// The errors of a run over whole periods.
struct LongRun {
  double energy = 0, phi = 0;  ///< [J, m]
  std::vector<double> phase;   ///< after each period, full turns included [rad]
};

/// Follows the phase from period to period, in which it changes by less than half a turn.
class Phases : public SimulationObserver {
 public:
  explicit Phases(const Recurrence& motion) : motion_(motion) {}
  bool sample(const MotionSample& sample) override {
    if (phase.empty()) start_ = sample.state;
    const double before = phase.empty() ? 0 : phase.back();
    phase.push_back(before +
                    std::remainder(motion_.phase(start_, sample.state) - before, 2 * std::numbers::pi));
    return true;
  }
  std::vector<double> phase;

 private:
  const Recurrence& motion_;
  MechanismState<double> start_;
};

LongRun run_over(const Recurrence& motion, const Kept& kept, long periods) {
  SimulationOptions options;
  options.integrator = kept.method;
  options.formulation = kept.formulation;
  options.end = static_cast<double>(periods) * motion.period;
  options.output_step = motion.period;
  options.step = motion.period / static_cast<double>(kept.steps);
  Phases phases(motion);
  const SimulationReport report = simulate(make_model<double>(motion.scene), options, phases);
  return {report.unaccounted_energy, report.phi, std::move(phases.phase)};
}

/// The energy error of a symplectic method stays as it is, and its phase error grows in proportion to the
/// time. The others lose energy in proportion to the time, and the phase error grows with its square, as long
/// as the motion has not changed.
void judge_periods(Judge& judge, const Recurrence& motion, const Kept& kept, long all) {
  const bool is_symplectic = kept.is_symplectic;
  const auto part_of = [](long count) { return std::max(1L, count / 100); };
  const LongRun some = run_over(motion, kept, part_of(all)), whole = run_over(motion, kept, all);
  const auto add = [&](const std::string& quantity, double value, double tolerance, double factor,
                       const char* law) {
    Row row = judge.row(kept.formulation, kept.name(), quantity);
    row.value = value;
    row.tolerance = tolerance;
    row.threshold = factor * tolerance;
    row.why = law;
    judge.add(judge.judged(row));
  };
  const double longer = static_cast<double>(all) / static_cast<double>(part_of(all)),
               rounding = unit_roundoff<double>() * static_cast<double>(all * kept.steps);
  // rounding errors of the steps add up at most in proportion to their number
  add("energy [J]", whole.energy, some.energy * (is_symplectic ? 1 : longer) + rounding * motion.energies,
      factors::growth, is_symplectic ? "as over a hundredth of the run" : "in proportion to the time");
  add("Phi [m]", whole.phi, HardMotion::of_a_step(standard_rtol) * motion.size, factors::phi,
      "the tolerance of chosen steps");
  const long phased = kept.in_phase > 0 ? std::min(all, kept.in_phase) : all;
  const double times = static_cast<double>(phased) / static_cast<double>(part_of(phased)),
               ratio = is_symplectic ? times : times * times;
  const auto phase_after = [&](long count) { return std::abs(whole.phase.at(count)); };
  const double law = phase_after(part_of(phased)) * ratio + rounding;
  add(fmt::format("phase after {} periods [rad]", phased), phase_after(phased),
      kept.in_phase > 0 ? std::min(law, small_difference / factors::growth) : law, factors::growth,
      is_symplectic ? "in proportion to the time" : "with the square of the time");
}

/// All methods, each in one formulation.
void judge_periods(Judge& judge, const Recurrence& motion, double periods) {
  const long all = std::lround(periods);
  for (const Kept& kept : {Kept{"rattle", "r-omega", 100, 0, true},
                           {"generalized-alpha", "r-p", 100, 10, false},
                           {"radau9", "r-epsilon", motion.steps, 10'000, false}}) {
    const auto& wanted = judge.formulations();
    if (std::find(wanted.begin(), wanted.end(), kept.formulation) == wanted.end()) continue;
    try {
      judge_periods(judge, motion, kept, all);
    } catch (const Error& error) {
      judge.add(judge.ended(judge.row(kept.formulation, kept.name(), "whole run"), error.what(), error.when(),
                            motion.scene, 0, static_cast<double>(all) * motion.period));
    }
  }
}

/// The pendulum over one second by given steps: the error does not grow as they become shorter, but for the
/// multipliers of index 3, which know positions only to their rounding, u / h^2.
void judge_short_steps(Judge& judge, double h) {
  const scenes::Scene scene = pendulum();
  const auto model = make_model<double>(scene);
  SimulationOptions options;
  options.integrator = "rkf78";
  options.end = 1;
  options.output_step = 0.05;
  options.tolerances = {1e-13, 1e-15};
  Samples exact;
  simulate(model, options, exact);
  for (const std::string& method : methods_of("short_steps", judge.is_quick()))
    for (const std::string& formulation : judge.formulations()) {
      options.integrator = method;
      options.formulation = formulation;
      options.step = *options.output_step / std::ceil(*options.output_step / h * (1 - 1e-9));
      Samples found;
      Row row = judge.row(formulation, method, "position [m]");
      SimulationReport report;
      try {
        report = simulate(model, options, found);
      } catch (const Error& error) {
        judge.add(judge.ended(row, error.what(), error.when(), scene, 0, options.end));
        continue;
      }
      for (std::size_t k = 0; k < exact.all.size(); ++k)
        raise(row.value, (found.all[k].state.pose[0].r - exact.all[k].state.pose[0].r).norm());
      const double omega = std::sqrt(g / arm), u = unit_roundoff<double>();
      // of a method of order 2, and rounding of every step
      row.tolerance = omega * h * omega * h * arm + u / h * arm;
      row.threshold = factors::law * row.tolerance;
      row.why = "law (omega h)^2 + u / h";
      judge.add(judge.judged(row));
      if (!report.has_raw_lambda) continue;
      row.quantity = "raw lambda [N]";
      row.value = report.lambda_gap;
      // Newton's method takes violations of 16 epsilon for rounding, and does not correct them. A correction
      // of v' moves the position by beta h^2, and lambda damps by rho from step to step.
      row.tolerance =
          (omega * h + factors::undamped * integrators::rounding<double>() * arm / (g * h * h)) * mass * g;
      row.threshold = factors::law * row.tolerance;
      row.why = "law omega h + 256 epsilon l / (g h^2), relative to the weight";
      judge.add(judge.judged(row));
    }
}

}  // namespace

Family long_runs() {
  return {"long_runs",
          "many periods, and very short steps",
          {{"swings",
            "number of periods of a pendulum",
            {10, 1e6, true},
            10,
            {200},
            {1e5},
            [](Judge& judge, double periods) { judge_periods(judge, swinging(), periods); },
            [](double) { return pendulum(); }},
           {"turns",
            "number of turns of a slider-crank",
            {200, 1e6, true},
            200,
            {500},
            {1e5},
            [](Judge& judge, double turns) { judge_periods(judge, turning(), turns); },
            [](double) { return slider_crank(); }},
           {"short_steps",
            "length of the step [s], or a little less, so that it divides the run",
            {1e-7, 0.05},
            2e-3,
            {1e-4},
            {1e-3, 1e-4, 1e-5, 5e-6, 5e-7},
            judge_short_steps,
            [](double) { return pendulum(); }}}};
}

}  // namespace trivium::hard
