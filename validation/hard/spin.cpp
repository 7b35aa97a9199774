/// Fast spins, a sleeping top on both sides of its stability limit, and flips about an intermediate axis.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "base/raise.hpp"
#include "bodies/numbers/scalar.hpp"
#include "scenes/building.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/make_mechanism.hpp"
#include "simulation/simulate.hpp"
#include "validation/hard/factors.hpp"
#include "validation/hard/family.hpp"
#include "validation/hard/known_motions.hpp"
#include "validation/hard/methods.hpp"
#include "validation/hard/placing.hpp"
#include "validation/hard/solved_state.hpp"

namespace trivium::hard {

namespace {

// the top of the catalogue [kg, m, kg m^2, m/s^2]; it spins about its y axis
constexpr double mass = 15, transverse = mass + 0.234375, axial = 0.46875, g = 9.81;

scenes::Scene fast_top(double spin) {
  scenes::Scene scene = load_scene("heavy_top");
  scene.name = fmt::format("fast_top_{:g}", spin);
  scene.bodies[0].angular_velocity[1] = spin;
  return scene;
}

/// The largest |p . p - 1| of r-p; methods normalise it, or treat it as a constraint.
void judge_normalisation(Judge& judge, const RunOfCase& run) {
  if (run.row.formulation != "r-p") return;
  Row row = judge.row(run.row.formulation, run.row.method, "|p.p - 1| [-]");
  row.value = run.report.normalisation;
  row.tolerance = unit_roundoff<double>();
  row.threshold = factors::state * row.tolerance;
  judge.add(judge.judged(row));
}

void judge_fast_top(Judge& judge, double spin) {
  HardMotion motion;
  motion.scene = fast_top(spin);
  motion.end = spin > 2000 ? 1 : judge.is_quick() || judge.is_twin() ? 2 : 100;
  motion.step = 0.1 / spin;
  motion.rtol = judge.is_quick() ? 1e-10 : 1e-12;  // for as many steps as a fast spin needs
  motion.monitor = Monitor::positions;
  motion.starts = 2;  // a run of a fast top has 1e6 steps
  motion.methods = methods_of("fast_top", judge.is_quick());
  motion.also = judge_normalisation;
  // 100 s are 1e6 given steps of a method in a formulation: their errors show in a tenth of them
  constexpr double most_of_given_steps = 10;
  if (motion.end > most_of_given_steps) {
    HardMotion begin = motion;
    begin.end = most_of_given_steps;
    begin.chooses_steps = begin.beside_simbody = false;
    judge.motion(begin);
    motion.gives_steps = false;
  }
  const ExactMotion exact = judge.motion(motion);
  double off = 0;
  for (const auto& state : exact.states())
    raise(off, std::abs(state.pose[0].r[2] - height_of_top(spin, state.t)));
  judge.add(judge.exact_row("height by elliptic functions [m]", off, exact));
}

/// A top whose axis is `tilt` off the vertical; its spin is `ratio` times the least at which it stays
/// upright.
constexpr double tilt = 1e-4;
scenes::Scene sleeping_top(double ratio) {
  scenes::Scene scene = load_scene("heavy_top");
  scene.name = fmt::format("sleeping_top_{:g}", ratio);
  scenes::Body& top = scene.bodies[0];
  top.orientation = scenes::AxisAngle{{1, 0, 0}, std::numbers::pi / 2 - tilt};  // its y axis stands along z
  top.angular_velocity = {0, ratio * std::sqrt(4 * transverse * mass * g) / axial, 0};
  pin_at_origin(top, {0, -1, 0});
  return scene;
}

/// The tilt at time t by the linear equation A x'' - i C n x' - m g l x = 0 of the complex inclination x.
double linear_tilt(double ratio, double t) {
  const std::complex<double> i(0, 1);
  const double weight = mass * g / transverse;
  const std::complex<double> half = i * ratio * std::sqrt(weight),
                             root = std::sqrt(std::complex(weight * (1 - ratio * ratio)));
  const std::complex<double> r_1 = half + root, r_2 = half - root;
  if (r_1 == r_2) return std::abs(tilt * (1.0 - r_1 * t) * std::exp(r_1 * t));  // the limit itself
  return std::abs(tilt * (r_2 * std::exp(r_1 * t) - r_1 * std::exp(r_2 * t)) / (r_2 - r_1));
}

void judge_sleeping_top(Judge& judge, double ratio) {
  HardMotion motion;
  motion.scene = sleeping_top(ratio);
  motion.end = 2;
  motion.step = 2e-4;
  motion.monitor = Monitor::positions;
  const ExactMotion exact = judge.motion(motion);
  double off = 0, largest = tilt;
  for (const auto& state : exact.states()) {
    const auto& r = state.pose[0].r;
    const double linear = linear_tilt(ratio, state.t);
    raise(largest, linear);
    raise(off, std::abs(std::hypot(r[0], r[1]) - linear) / linear);
  }
  // the linear equation leaves out terms of the size of the squared tilt
  Row row = judge.row("r-omega", "exact motion", "tilt by the linear growth rate [-]");
  row.value = off;
  row.tolerance = largest * largest;
  row.threshold = factors::chosen_steps * row.tolerance;
  judge.add(judge.judged(row));
}

/// |p . p - 1| of a run of r-p that is not projected, so that nothing normalises p.
void judge_unprojected(Judge& judge, const HardMotion& motion) {
  const auto& asked = judge.formulations();
  if (std::find(asked.begin(), asked.end(), "r-p") == asked.end()) return;
  SimulationOptions options;
  options.formulation = "r-p";
  options.integrator = "dopri5";
  options.end = motion.end;
  options.tolerances = motion.tolerances(motion.rtol);
  options.projects = false;
  LimitedSamples samples(most_steps);
  Row row = judge.row("r-p", "dopri5, not projected", "|p.p - 1| [-]");
  SimulationReport report;
  try {
    report = simulate(make_model<double>(motion.scene), options, samples);
  } catch (const Error& error) {
    return judge.add(judge.ended(row, error.what(), error.when(), motion.scene, 0, motion.end));
  }
  row.value = report.normalisation;
  row.tolerance = static_cast<double>(report.counters.steps) * motion.of_a_step();
  row.threshold = factors::chosen_steps * row.tolerance;
  const double figure = quote_warnings(row, report);
  judge.add(judge.judged(row, figure));
}

void judge_flips(Judge& judge, double flips) {
  HardMotion motion;
  motion.scene = load_scene("dzhanibekov");
  const scenes::Body& body = motion.scene.bodies[0];
  // between two compared states are no whole flips, so that all phases are among them
  const double between =
      flips < hard_outputs ? (flips + 0.3) / hard_outputs : std::floor(flips / hard_outputs) + 0.618;
  motion.end = between * hard_outputs * time_of_a_flip(body);
  motion.step = flips > 20 ? 0.01 : flips > 5 ? 0.0025 : 0.02;
  if (flips > 20) {
    motion.methods = methods_of("spin/many_flips", judge.is_quick());
    motion.starts = 5;  // a run takes minutes
  }
  motion.directions = 8;                            // few of all directions delay or hasten flips
  motion.rtol = flips > 5 ? 1e-12 : standard_rtol;  // each flip enlarges errors
  motion.also = judge_normalisation;
  const ExactMotion exact = judge.motion(motion);
  double off = 0;
  for (const auto& state : exact.states()) {
    const auto law = angular_velocity_of_flips(body, state.t);
    raise(off, (state.twist[0].omega_bar - Vector3<double>(law[0], law[1], law[2])).norm());
  }
  judge.add(judge.exact_row("omega_bar by elliptic functions [rad/s]", off, exact));
  judge_unprojected(judge, motion);
}

/// A ball on a spherical joint in its middle, which spins about no axis of its frame and is turned by a
/// torque. Its inertia is 1 kg m^2 about every axis, so that omega_bar' is the torque, however fast it spins.
scenes::Scene spinning_ball(double spin) {
  scenes::Scene scene;
  scene.name = fmt::format("spinning_ball_{:g}", spin);
  scene.bodies = {building::body("ball", 3, {1, 1, 1})};
  scene.bodies[0].orientation = scenes::EulerAngles{{0.7, 1.1, -0.4}, {}};
  scene.bodies[0].angular_velocity = {0.48 * spin, 0.6 * spin, 0.64 * spin};
  scene.constraints = {building::joint(JointType::spherical, "middle",
                                       building::side(scenes::ground, scenes::Vector3{}),
                                       building::side(0, scenes::Vector3{}))};
  scene.effects = {building::gravity(), Torque<double>{"motor", 0, {0.3, -1.7, 0.9}, ComponentFrame::body}};
  return scene;
}

/// r-p, printed, and r-epsilon by both solvers have the unknowns p'' and eps'', which hold terms of the size
/// |omega|^2, and lose u |omega|^2 of omega_bar'. The mended forms have the unknown omega_bar' and lose
/// nothing.
void judge_printed_spin(Judge& judge, double spin) {
  SolvedStates solved = solve_state(spinning_ball(spin), judge.formulations());
  for (int k = 1; k < 5; ++k) {  // at one spin roundings may cancel
    const SolvedStates near = solve_state(spinning_ball((1 + 0.01 * k) * spin), judge.formulations());
    for (std::size_t n = 0; n < solved.all.size(); ++n)
      if (near.all[n].omega_bar_dot > solved.all[n].omega_bar_dot) solved.all[n] = near.all[n];
  }
  for (const SolvedState& state : solved.all) {
    const bool loses =
        state.formulation == "r-epsilon" || (state.formulation == "r-p" && state.solver == "printed");
    Row row = judge.row(state.formulation, state.solver, "omega_bar' [rad/s^2]");
    const double law = unit_roundoff<double>() * (loses ? std::max(1.0, spin * spin) : 1);
    row.value = state.omega_bar_dot;
    row.tolerance = law;
    row.amplification = solved.kappa;
    row.threshold = factors::law * law * solved.kappa;
    row.why = fmt::format("the worst of five spins up to 4 % above: {:.2g} of the law u{}",
                          state.omega_bar_dot / law, loses ? " |omega|^2" : "");
    judge.add(judge.judged(row, state.announced));
    if (!loses || judge.is_twin()) continue;  // at 1 rad/s nothing is lost
    row.quantity = "law over error of omega_bar' [-]";
    row.value = law / state.omega_bar_dot;
    row.tolerance = row.amplification = 1;
    row.threshold = factors::law;
    row.why = "the loss is there";
    judge.add(judge.judged(row));
  }
}

}  // namespace

Family spin() {
  return {"spin",
          "fast tops, a sleeping top, flips",
          {{"fast_top",
            "spin [rad/s], for 100 s (above 2000 rad/s 1 s, quick 2 s)",
            {1, 2e4},
            20,
            {150},
            {150, 1000, 10000},
            judge_fast_top,
            fast_top},
           {"sleeping_top",
            "spin over the least stable one",
            {0.1, 10},
            1.5,
            {0.95},
            {0.8, 0.95, 1.05, 1.2},
            judge_sleeping_top,
            sleeping_top},
           {"flips",
            "number of flips",
            {1, 100, true},
            1,
            {4},
            {10, 100},
            judge_flips,
            [](double) { return load_scene("dzhanibekov"); }},
           {"printed_spin",
            "spin [rad/s]",
            {1, 1e6},
            1,
            {1e4},
            {1e2, 1e3, 1e4, 1e5},
            judge_printed_spin,
            spinning_ball}}};
}

}  // namespace trivium::hard
