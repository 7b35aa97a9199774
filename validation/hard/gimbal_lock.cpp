/// Gimbal lock: how lambda is lost near the singularity of a chart, on which law, and how flights pass it.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "base/number_text.hpp"
#include "bodies/numbers/scalar.hpp"
#include "scenes/building.hpp"
#include "validation/hard/factors.hpp"
#include "validation/hard/family.hpp"
#include "validation/hard/methods.hpp"
#include "validation/hard/placing.hpp"
#include "validation/hard/solved_state.hpp"

namespace trivium::hard {

namespace {

/// A top on a spherical joint whose middle Euler angle is `distance` [rad] away from the singularity.
scenes::Scene near_lock(const EulerSequence& sequence, double distance) {
  scenes::Scene scene;
  scene.name = fmt::format("near_lock_{}_{:g}", sequence.name(), distance);
  scenes::Body top = building::body("top", 2, {0.4, 0.5, 0.3});
  const double middle = sequence.is_symmetric() ? distance : std::numbers::pi / 2 - distance;
  top.orientation = scenes::EulerAngles{{0.4, middle, 0.3}, sequence};
  top.angular_velocity = {1, 2, 3};
  const scenes::Vector3 tip{0.1, 0.2, 0.3};
  pin_at_origin(top, tip);
  scene.bodies = {top};
  scene.constraints = {building::joint(JointType::spherical, "pin",
                                       building::side(scenes::ground, scenes::Vector3{}),
                                       building::side(0, tip))};
  Torque<double> torque;
  torque.components = {TimeFunction(1), TimeFunction(2), TimeFunction(3)};
  scene.effects = {torque};
  return scene;
}

/// The exponent n of the law u / distance^n by which a formulation loses lambda.
int exponent_of(const std::string& formulation) {
  if (formulation == "r-epsilon") return 3;
  return formulation == "r-epsilon-omega-first" ? 1 : 0;
}

/// The worst of the twelve sequences, in each formulation by each solver.
void judge_laws(Judge& judge, double distance) {
  for (const std::string_view name : euler_sequence_names) {
    judge.begin_part(fmt::format("sequence {}", name));
    const EulerSequence sequence = *parse_euler_sequence(name);
    const scenes::Scene scene = near_lock(sequence, distance);
    const SolvedStates solved = solve_state(scene, judge.formulations(), ChartOptions{sequence, false});
    for (const SolvedState& state : solved.all) {
      const int exponent = exponent_of(state.formulation);
      const double law = unit_roundoff<double>() / std::pow(distance, exponent);
      const bool is_lost = law >= factors::lost_law;
      Row row = judge.row(state.formulation, state.solver, "lambda [-]");
      row.value = state.lambda;
      row.tolerance = law;
      row.amplification = solved.kappa;
      row.threshold = is_lost ? 0 : std::min(factors::law * law * solved.kappa, small_difference);
      row.why = is_lost ? fmt::format("law u/theta^{}, which is lost; stated error {:.1e}", exponent,
                                      state.announced)
                        : fmt::format("{:.2g} of the law u/theta^{}", state.lambda / law, exponent);
      judge.add(state.refusal.empty() ? judge.judged(row, state.announced)
                                      : judge.refused(row, state.refusal, scene));
    }
  }
  judge.keep_worst_part();
}

/// A pendulum that passes the singularity of the sequence i-j-k at about `distance` [rad]. There body axis k
/// is along axis i of the ground, which is the vertical.
scenes::Scene flight_past(const EulerSequence& sequence, double distance) {
  const auto [i, j, k] = sequence.axis;
  scenes::Scene scene;
  scene.name = fmt::format("flight_{}_{:g}", sequence.name(), distance);
  const double tilt = 0.7, g = 9.81;
  const int other = 3 - j - k;
  scenes::Vector3 inertia{}, pivot{}, down{};
  inertia[other] = 0.1;
  inertia[j] = 0.2;
  inertia[k] = 0.15;
  pivot[k] = 1;
  // at the singularity axis k of the body is along axis i, or against it for i-j-k with i x j = -k
  down[i] = sequence.is_symmetric() || j == (i + 1) % 3 ? -g : g;
  scenes::Body body = building::body("bob", 1, inertia);
  body.orientation =
      scenes::EulerAngles{{0, sequence.is_symmetric() ? tilt : std::numbers::pi / 2 - tilt, 0}, sequence};
  body.angular_velocity[other] = distance * std::sqrt(g);  // sideways
  pin_at_origin(body, pivot);
  scene.bodies = {body};
  scene.constraints = {building::joint(JointType::spherical, "pivot",
                                       building::side(scenes::ground, scenes::Vector3{}),
                                       building::side(0, pivot))};
  scene.effects = {Gravity<double>{"", {down[0], down[1], down[2]}}};
  return scene;
}

/// The energy, with the tolerance of the motion. It counts v^2, so that twice the error of v enters.
void judge_energy(Judge& judge, const RunOfCase& run) {
  Row row = judge.row(run.row.formulation, run.row.method, "energy [-]");
  row.value = run.report.unaccounted_energy / run.report.largest_kinetic;
  row.tolerance = factors::energy * run.row.tolerance;
  row.threshold = run.factor * row.tolerance;
  row.why = counted(run.report.reframings, "change of chart", "changes of chart");
  judge.add(judge.judged(std::move(row), run.figure));
}

HardMotion motion_past(const EulerSequence& sequence, double distance) {
  HardMotion motion;
  motion.scene = flight_past(sequence, distance);
  motion.charts.sequence = sequence;
  motion.end = 2;
  motion.step = 2e-3;
  motion.also = judge_energy;
  return motion;
}

scenes::Scene flight(double distance) { return flight_past({}, distance); }

void judge_flight(Judge& judge, double distance, bool reframe) {
  HardMotion motion = motion_past({}, distance);
  motion.reference = ReferenceRun::in_quad;
  motion.charts.reframe = reframe;
  judge.motion(motion);
}

/// The worst of the twelve sequences, each past its own singularity.
void judge_sequences(Judge& judge, double distance, bool reframe) {
  for (const std::string_view name : euler_sequence_names) {
    judge.begin_part(fmt::format("sequence {}", name));
    HardMotion motion = motion_past(*parse_euler_sequence(name), distance);
    motion.charts.reframe = reframe;
    motion.methods = methods_of("gimbal_lock/sequences", judge.is_quick());
    motion.beside_simbody = false;
    judge.motion(motion);
  }
  judge.keep_worst_part();
}

}  // namespace

Family gimbal_lock() {
  const std::vector<double> distances{1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
  return {"gimbal_lock",
          "near the singularity of Euler angles",
          {{"near_lock",
            "distance from the singularity [rad]",
            {1e-15, 0.7},
            0.5,
            distances,
            {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 5.83e-6, 3e-6, 1e-6, 1.87e-7, 1e-7, 1e-8},
            judge_laws},
           {"flight",
            "closest approach [rad], charts are changed",
            {0, 0.7},
            0.5,
            {1e-2, 1e-6},
            distances,
            [](Judge& judge, double distance) { judge_flight(judge, distance, true); },
            flight},
           {"raw_flight",
            "closest approach [rad], charts are kept",
            {0, 0.7},
            0.5,
            {1e-2, 1e-6},
            distances,
            [](Judge& judge, double distance) { judge_flight(judge, distance, false); },
            flight},
           {"sequences",
            "closest approach [rad], each of the twelve sequences",
            {0, 0.7},
            0.5,
            {1e-4},
            distances,
            [](Judge& judge, double distance) { judge_sequences(judge, distance, true); }},
           {"raw_sequences",
            "closest approach [rad], each of the twelve sequences, charts are kept",
            {0, 0.7},
            0.5,
            {},
            {1e-2, 1e-5},
            [](Judge& judge, double distance) { judge_sequences(judge, distance, false); }}}};
}

}  // namespace trivium::hard
