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
#include "integrators/methods.hpp"
#include "scenes/building.hpp"
#include "scenes/make_mechanism.hpp"
#include "simulation/neighbouring_start.hpp"
#include "simulation/simulate.hpp"
#include "validation/hard/exact_motion.hpp"
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
          3,  // crank and rod
          1,
          24,
          [](const MechanismState<double>& start, const MechanismState<double>& state) {
            const auto angle = [](const MechanismState<double>& at) {
              return std::atan2(at.pose[0].r[1], at.pose[0].r[0]);
            };
            return angle(state) - angle(start);
          }};
}

/// A method in one formulation, with its steps in a period.
struct Kept {
  std::string method, formulation;
  long steps;
  bool is_symplectic;
  std::string name() const { return fmt::format("{}, h = T/{}", method, steps); }
};

/// The errors of a run, after each period; the phase with its full turns.
class LongRun : public SimulationObserver {
 public:
  std::vector<double> energy, phase;  ///< [J, rad]

  LongRun(const Recurrence& motion, const Kept& kept, long periods) : motion_(motion) {
    SimulationOptions options;
    options.integrator = kept.method;
    options.formulation = kept.formulation;
    options.end = static_cast<double>(periods) * motion.period;
    options.output_step = motion.period;
    options.step = motion.period / static_cast<double>(kept.steps);
    report = simulate(make_model<double>(motion.scene), options, *this);
  }
  SimulationReport report;

 private:
  bool sample(const MotionSample& sample) override {
    if (phase.empty()) start_ = sample;
    const double before = phase.empty() ? 0 : phase.back();
    // from period to period it changes by less than half a turn
    phase.push_back(before +
                    std::remainder(motion_.phase(start_.state, sample.state) - before, 2 * std::numbers::pi));
    energy.push_back(sample.energy - start_.energy);
    return true;
  }

  const Recurrence& motion_;
  MotionSample start_;
};

/// The exact motion amplifies differences over so many periods. Its energy stays, so that neighbours of other
/// periods drift apart in proportion to the time. Outputs are at all phases.
constexpr double measured_periods = 1.1 * hard_outputs;
double amplification_after(const ExactMotion& exact, long periods) {
  return exact.amplification() * std::max(1.0, static_cast<double>(periods) / measured_periods);
}

/// Judges a row of a run. The run's warnings concern it if it misses its threshold; a twin must have none.
void add_with_warnings(Judge& judge, Row row, const SimulationReport& report) {
  const double figure = row.is_met() && !judge.is_twin() ? 0 : quote_warnings(row, report);
  judge.add(judge.judged(row, figure));
}

/// A symplectic method of order 2 errs as on a vibration of rate omega: its energy by (omega h)^2 / 8 at any
/// time, its frequency by (omega h)^2 / 24. Others are judged by the local errors that they state: these add
/// up to errors of the energy, and the motion amplifies them to errors of the phase.
void judge_periods(Judge& judge, const Recurrence& motion, const ExactMotion& exact, const Kept& kept,
                   long all) {
  const LongRun run(motion, kept, all);
  const auto add = [&](const char* quantity, double value, double tolerance, double factor,
                       const std::string& law, double amplification = 1) {
    Row row = judge.row(kept.formulation, kept.name(), quantity);
    row.value = std::abs(value);
    row.tolerance = tolerance;
    row.amplification = amplification;
    row.threshold = std::min(factor * tolerance * amplification, small_difference);
    row.why = law;
    add_with_warnings(judge, row, run.report);
  };
  add("Phi [m]", run.report.phi, integrators::rounding<double>() * motion.size, factors::law,
      "law 16 epsilon l");
  const double count = static_cast<double>(all),
               turn = 2 * std::numbers::pi / static_cast<double>(kept.steps);
  if (kept.is_symplectic) {
    // rounding errors of the steps add up at most in proportion to their number
    const double rounding = unit_roundoff<double>() * static_cast<double>(all * kept.steps);
    add("energy [-]", run.report.unaccounted_energy / motion.energies, turn * turn / 8 + rounding,
        factors::law, "law (omega h)^2 / 8 at any time");
    add("frequency [-]", run.phase.at(all) / (2 * std::numbers::pi * count), turn * turn / 24 + rounding,
        factors::law, "law (omega h)^2 / 24");
    return;
  }
  const double stated = stated_by(run.report, exact, motion.period / static_cast<double>(kept.steps));
  add("energy [-]", run.energy.at(all) / motion.energies, stated, factors::given_steps * factors::energy,
      "stated local errors");
  // the phase for as long as its threshold promises anything
  const auto stated_after = [&](long periods) { return stated * static_cast<double>(periods) / count; };
  long phased = all;
  while (phased > 1 &&
         factors::given_steps * stated_after(phased) * amplification_after(exact, phased) > small_difference)
    phased = (phased + 1) / 2;
  add("phase [rad]", run.phase.at(phased), stated_after(phased), factors::given_steps,
      fmt::format("after {} periods, by stated local errors", phased), amplification_after(exact, phased));
}

/// All methods, each in one formulation.
void judge_periods(Judge& judge, const Recurrence& motion, double periods) {
  const long all = std::lround(periods);
  // of methods of order 2, whose errors the simulation warns of if it takes the steps of the long runs
  const long steps = judge.is_twin() ? 2000 : 50;
  HardMotion measured;
  measured.scene = motion.scene;
  measured.end = measured_periods * motion.period;
  measured.starts = 1;  // it returns to it
  measured.directions = neighbours;
  const ExactMotion exact(measured);
  for (const Kept& kept : {Kept{"rattle", "r-omega", steps, true},
                           {"generalized-alpha", "r-epsilon", steps, false},
                           {"radau9", "r-p", motion.steps, false}}) {
    const auto& wanted = judge.formulations();
    if (std::find(wanted.begin(), wanted.end(), kept.formulation) == wanted.end()) continue;
    try {
      judge_periods(judge, motion, exact, kept, all);
    } catch (const Error& error) {
      judge.add(judge.ended(judge.row(kept.formulation, kept.name(), "whole run"), error.what(), error.when(),
                            motion.scene, 0, static_cast<double>(all) * motion.period));
    }
  }
  // over all periods it takes too many steps
  judge.add_simbody(measured, exact, fmt::format("over {} periods: ", measured_periods));
}

/// The methods of short_steps whose velocities need not meet their rows.
const std::vector<std::string> index_3{"generalized-alpha", "hht", "bdf"};

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
  // 2e5 steps and more: by each method in one formulation, as for many periods
  const bool has_very_many = h < 1e-5;
  std::size_t turn_of = 0;
  for (const std::string& method : methods_of("short_steps", judge.is_quick())) {
    std::vector<std::string> formulations = judge.formulations();
    if (has_very_many) formulations = {formulations[turn_of++ % formulations.size()]};
    for (const std::string& formulation : formulations) {
      options.integrator = method;
      options.formulation = formulation;
      options.step = *options.output_step / std::ceil(*options.output_step / h * (1 - 1e-9));
      Samples found;
      SimulationReport report;
      try {
        report = simulate(model, options, found);
      } catch (const Error& error) {
        judge.add(judge.ended(judge.row(formulation, method, "whole run"), error.what(), error.when(), scene,
                              0, options.end));
        continue;
      }
      const auto add = [&](const char* quantity, double value, double tolerance, const std::string& law) {
        Row row = judge.row(formulation, method, quantity);
        row.value = value;
        row.tolerance = tolerance;
        row.threshold = factors::law * tolerance;
        row.why = "law " + law;
        add_with_warnings(judge, row, report);
      };
      double off = 0;
      for (std::size_t k = 0; k < exact.all.size(); ++k)
        raise(off, (found.all[k].state.pose[0].r - exact.all[k].state.pose[0].r).norm());
      const integrators::MethodInfo& info = *integrators::find_method(method);
      const double turn = std::sqrt(g / arm) * h;  // omega h
      // what the method leaves out, and rounding of every step
      const double law = std::pow(turn, info.standard_order) + unit_roundoff<double>() / h;
      const std::string law_text = fmt::format("(omega h)^{} + u / h", info.standard_order);
      add("position [m]", off, law * arm, law_text);
      add("energy [-]", report.unaccounted_energy / (mass * g * arm), law, law_text);
      add("Phi [m]", report.phi, integrators::rounding<double>() * arm, "16 epsilon l");
      if (!report.has_raw_lambda) continue;
      // Newton's method takes violations of 16 epsilon for rounding, and does not correct them. With index 3
      // a correction of v' moves the position by beta h^2, and lambda damps by rho from step to step; with
      // the velocity rows of index 2 it moves the velocity by h.
      const int order = info.raw_lambda_order > 0 ? info.raw_lambda_order : info.standard_order;
      const bool has_index_3 = std::find(index_3.begin(), index_3.end(), method) != index_3.end();
      const double known = integrators::rounding<double>() / turn,
                   rounding = has_index_3 ? factors::undamped * known / turn : known;
      add("raw lambda [N]", report.lambda_gap, (std::pow(turn, order) + rounding) * mass * g,
          fmt::format("(omega h)^{} + {}, relative to the weight", order,
                      has_index_3 ? "256 epsilon / (omega h)^2" : "16 epsilon / (omega h)"));
    }
  }
}

/// A motion over so many periods; `number`: what they are called.
Case many_periods(const char* name, const char* number, Recurrence (*motion)(), double least, double quick) {
  return {name,
          number,
          {least, 1e6, true},
          least,
          {quick},
          {1e5},
          [motion](Judge& judge, double periods) { judge_periods(judge, motion(), periods); },
          [motion](double) { return motion().scene; }};
}

}  // namespace

Family long_runs() {
  return {"long_runs",
          "many periods, and very short steps",
          {many_periods("swings", "number of periods of a pendulum", swinging, 10, 200),
           many_periods("turns", "number of turns of a slider-crank", turning, 20, 500),
           {"short_steps",
            "length of the step [s], or a little less, so that it divides the run (below 1e-5 each method in "
            "one formulation)",
            {1e-7, 0.01},
            2e-3,
            {1e-4},
            {1e-3, 1e-4, 1e-5, 5e-6, 5e-7},
            judge_short_steps,
            [](double) { return pendulum(); }}}};
}

}  // namespace trivium::hard
