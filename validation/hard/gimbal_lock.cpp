/// Gimbal lock: how lambda is lost near the singularity of a chart, on which law, and how flights pass it.

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "base/number_text.hpp"
#include "bodies/numbers/scalar.hpp"
#include "scenes/building.hpp"
#include "validation/hard/factors.hpp"
#include "validation/hard/family.hpp"
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
  constexpr double law_holds_below = 0.1;
  std::map<std::pair<std::string, std::string>, Row> worst;
  for (const std::string_view name : euler_sequence_names) {
    const EulerSequence sequence = *parse_euler_sequence(name);
    const scenes::Scene scene = near_lock(sequence, distance);
    const SolvedStates solved = solve_state(scene, judge.formulations(), ChartOptions{sequence, false});
    for (const SolvedState& state : solved.all) {
      const int exponent = exponent_of(state.formulation);
      const double law = unit_roundoff<double>() / std::pow(distance, exponent);
      Row row = judge.row(state.formulation, state.solver, "lambda [-]");
      row.value = state.lambda;
      row.tolerance = law;
      row.amplification = solved.kappa;
      row.threshold = law < law_holds_below ? factors::law * law * solved.kappa : 0;
      row.why = fmt::format("worst sequence {}; law u/theta^{}", name, exponent);
      if (law >= law_holds_below)
        row.why += fmt::format(", which is lost; stated error {:.1e}", state.announced);
      row = state.refusal.empty() ? judge.judged(row, state.announced)
                                  : judge.ended(row, state.refusal, 0.0, scene);
      const auto [at, is_first] = worst.try_emplace({state.formulation, state.solver}, row);
      if (!is_first && is_worse(row, at->second)) at->second = row;
    }
  }
  for (const auto& [key, row] : worst) judge.add(row);
}

/// A pendulum whose body axis z passes the vertical, where the sequence 3-1-3 is singular, at about
/// `distance` [rad].
scenes::Scene flight(double distance) {
  scenes::Scene scene;
  scene.name = fmt::format("flight_{:g}", distance);
  const double tilt = 0.7, rate = std::sqrt(9.81);
  scenes::Body body = building::body("bob", 1, {0.1, 0.2, 0.15});
  body.orientation = scenes::AxisAngle{{0, 1, 0}, tilt};
  // about the body's x axis, so that it moves sideways
  body.angular_velocity = {distance * rate, 0, 0};
  pin_at_origin(body, {0, 0, 1});
  scene.bodies = {body};
  scene.constraints = {building::joint(JointType::spherical, "pivot",
                                       building::side(scenes::ground, scenes::Vector3{}),
                                       building::side(0, scenes::Vector3{0, 0, 1}))};
  scene.effects = {building::gravity()};
  return scene;
}

/// The energy, with the tolerance of the motion. It counts v^2, so that twice the error of v enters.
void judge_energy(Judge& judge, const RunOfCase& run) {
  Row row = judge.row(run.row.formulation, run.row.method, "energy [-]");
  row.value = run.report.unaccounted_energy / run.report.largest_kinetic;
  row.tolerance = 2 * run.row.tolerance;
  row.threshold = run.factor * row.tolerance;
  row.why = counted(run.report.reframings, "change of chart", "changes of chart");
  judge.add(judge.judged(std::move(row), run.figure));
}

void judge_flight(Judge& judge, double distance, bool reframe) {
  HardMotion motion;
  motion.scene = flight(distance);
  motion.end = 2;
  motion.step = 2e-3;
  motion.reference = ReferenceRun::in_quad;
  motion.charts.reframe = reframe;
  motion.also = judge_energy;
  judge.motion(motion);
}

}  // namespace

Family gimbal_lock() {
  const std::vector<double> distances{1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
  return {"gimbal_lock",
          "near the singularity of Euler angles",
          {{"near_lock", "distance from the singularity [rad]", 0.5, distances, distances, judge_laws},
           {"flight",
            "closest approach [rad], charts are changed",
            0.5,
            {1e-2, 1e-6},
            distances,
            [](Judge& judge, double distance) { judge_flight(judge, distance, true); },
            flight},
           {"raw_flight",
            "closest approach [rad], charts are kept",
            0.5,
            {1e-2, 1e-6},
            distances,
            [](Judge& judge, double distance) { judge_flight(judge, distance, false); },
            flight}}};
}

}  // namespace trivium::hard
