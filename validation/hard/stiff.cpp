/// Stiff springs: an orbit on a spring, with and without damping, a vibration that must be followed, and the
/// flyball governor.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenes/catalogue.hpp"
#include "validation/hard/family.hpp"
#include "validation/hard/known_motions.hpp"

namespace trivium::hard {

namespace {

using scenes::Scene;

Scene orbit(double stiffness) { return orbit_on_spring(stiffness); }
Scene damped_orbit(double stiffness) { return orbit_on_spring(stiffness, 0.2 * std::sqrt(stiffness)); }

void judge_orbit(Judge& judge, Scene (*make)(double), double stiffness) {
  HardMotion motion;
  motion.scene = make(stiffness);
  // neighbours follow vibrations of the spring: of a stiffer one, over as many as at 4e8 N/m
  motion.end = (judge.is_quick() ? 0.2 : 2) * std::min(1.0, 2e4 / std::sqrt(stiffness));
  motion.step = 1e-3;
  motion.reference = ReferenceRun::stiff;
  motion.exact = set_orbit;
  motion.monitor = Monitor::positions;  // every difference of a position makes the spring vibrate
  motion.starts = 5;                    // which are followed step by step
  judge.motion(motion);
}

constexpr double amplitude = 0.05;  // [m]: large enough to be missed if it is damped away
constexpr double damping_ratio = 0.02;

/// The stone, of 1 kg, vibrates along x; `ratio`: of damping.
Scene vibration(double stiffness, double ratio) {
  return stone_on_spring(stiffness, 2 * ratio * std::sqrt(stiffness), 1 - amplitude, 0);
}

void judge_vibration(Judge& judge, double stiffness, double ratio) {
  HardMotion motion;
  motion.scene = vibration(stiffness, ratio);
  const bool is_short = judge.is_quick() || judge.is_twin();
  const double omega = std::sqrt(stiffness);
  motion.step = std::min(1e-3, 10 / omega);  // from 1e8 N/m on longer than a period
  // about 8 or 32 periods, and at least as many steps as outputs
  motion.end = std::max((is_short ? 50 : 200) / omega, hard_outputs * motion.step);
  motion.exact = [omega, ratio](MechanismState<double>& state) {
    const double damped = omega * std::sqrt(1 - ratio * ratio), c = std::cos(damped * state.t),
                 s = std::sin(damped * state.t), now = amplitude * std::exp(-ratio * omega * state.t);
    state.pose[0].r = {1 - amplitude + now * (c + ratio * omega / damped * s), 0, 0};
    state.twist[0].r_dot = {-now * omega * omega / damped * s, 0, 0};
  };
  judge.motion(motion);
}

Case vibrating(const char* name, double ratio) {
  return {name,
          "stiffness [N/m]",
          {1, 1e12},
          10,
          {1e8},
          {1e6, 4e6, 1e8, 1e10},
          [ratio](Judge& judge, double k) { judge_vibration(judge, k, ratio); },
          [ratio](double k) { return vibration(k, ratio); }};
}

/// The flyball governor of IFToMM A05, its springs and dampers `factor` times as stiff.
Scene governor(double factor) {
  Scene scene = load_scene("flyball_governor");
  scene.name = fmt::format("governor_{:g}", factor);
  for (scenes::Effect& effect : scene.effects)
    if (auto* spring = std::get_if<SpringDamper<double>>(&effect)) {
      spring->stiffness *= factor;
      spring->damping *= factor;
    }
  return scene;
}

void judge_governor(Judge& judge, double factor) {
  HardMotion motion;
  motion.scene = governor(factor);
  motion.end = judge.is_quick() ? 0.2 : 1;
  motion.step = judge.is_twin() ? 2e-4 : 1e-3;
  motion.reference = ReferenceRun::stiff;
  judge.motion(motion);
}

}  // namespace

Family stiff() {
  return {"stiff",
          "stiff springs and dampers",
          {{"orbit",
            "stiffness [N/m]",
            {200, 1e12},
            1e3,
            {1e8},
            {1e6, 1e8, 1e10},
            [](Judge& judge, double k) { judge_orbit(judge, orbit, k); },
            orbit},
           {"damped_orbit",
            "stiffness [N/m]",
            {200, 1e12},
            1e3,
            {},
            {1e6, 1e10},
            [](Judge& judge, double k) { judge_orbit(judge, damped_orbit, k); },
            damped_orbit},
           vibrating("vibration", 0),
           vibrating("damped_vibration", damping_ratio),
           {"governor",
            "factor of its stiffness and damping",
            {1e-6, 1e3},
            1e-3,
            {1},
            {1, 100},
            judge_governor,
            governor}}};
}

}  // namespace trivium::hard
