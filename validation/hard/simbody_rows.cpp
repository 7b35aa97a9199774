#include "validation/hard/simbody_rows.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "base/number_text.hpp"
#include "scenes/make_mechanism.hpp"
#include "validation/hard/factors.hpp"
#include "validation/simbody/motion.hpp"
#include "validation/simbody/translation.hpp"

namespace trivium::hard {

namespace {

/// More take minutes, and seldom get through.
constexpr int most_steps_of_simbody = 15'000;

Vector3<double> vector(const simbody::Vector3& v) { return {v[0], v[1], v[2]}; }

std::vector<MechanismState<double>> states_of(const simbody::Motion& motion) {
  std::vector<MechanismState<double>> states;
  for (const auto& bodies : motion.states) {
    MechanismState<double>& state = states.emplace_back();
    for (const simbody::BodyState& body : bodies) {
      state.pose.push_back({vector(body.r), {body.p[0], body.p[1], body.p[2], body.p[3]}});
      state.twist.push_back({vector(body.r_dot), vector(body.omega_bar)});
    }
  }
  return states;
}

}  // namespace

std::vector<Row> simbody_rows(const Judge& judge, const HardMotion& motion, const ExactMotion& exact,
                              double accuracy) {
  std::vector<Row> rows;
  if (exact.is_given_up()) return rows;
  std::vector<double> times;
  for (int k = 1; k <= hard_outputs; ++k) times.push_back(motion.start + k * exact.output_step());
  for (const auto& [name, which] :
       {std::pair("Simbody RungeKuttaMerson", simbody::Integrator::runge_kutta_merson),
        {"Simbody CPodes BDF", simbody::Integrator::cpodes_bdf}}) {
    Row row = judge.row("Simbody", name, motion.monitor == Monitor::motion ? "motion [-]" : "positions [-]");
    row.counts = false;
    const auto without_value = [&](Verdict verdict, const std::string& why) {
      row.value = std::numeric_limits<double>::quiet_NaN();
      row.verdict = verdict;
      row.why = why;
    };
    try {
      const simbody::Motion found = simbody::move(
          to_simbody(motion.scene, motion.start), simbody::Way::mobilizers, which, accuracy, times,
          motion.max_step.value_or(std::numeric_limits<double>::infinity()), most_steps_of_simbody);
      row.why = counted(found.steps, "step", "steps");
      row.tolerance = static_cast<double>(found.steps) * accuracy;
      if (exact.trouble().empty()) {
        judge_states(row, exact, states_of(found), factors::chosen_steps);
        row.verdict = row.is_met()            ? Verdict::survives
                      : std::isnan(row.value) ? Verdict::not_judged
                                              : Verdict::fails;
      } else {
        without_value(Verdict::fails, row.why + ", though the exact motion ends: " + exact.trouble());
      }
    } catch (const simbody::GivenUp& limit) {
      without_value(Verdict::not_judged, limit.what());
    } catch (const simbody::Refused& refusal) {
      without_value(Verdict::announces, refusal.what());
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace trivium::hard
