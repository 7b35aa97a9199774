/// Drivers and loads that change suddenly or fast: jumps of f' and f'', fast drivers, pulses shorter than a
/// step, drivers that lose their grip, and one that demands too much.

#include <algorithm>
#include <cmath>
#include <string>

#include "bodies/numbers/scalar.hpp"
#include "validation/hard/driven_scenes.hpp"
#include "validation/hard/family.hpp"

namespace trivium::hard {

namespace {

using scenes::Scene;

/// A fast crank is followed until it has turned by this angle [rad], slow ones for a second.
constexpr double turned = 30;

void judge_crank(Judge& judge, const Scene& scene, double end, const std::string& reason = {}) {
  HardMotion motion;
  motion.scene = scene;
  motion.end = end;
  motion.step = end / 5000;
  motion.reason = reason;
  judge.motion(motion);
}

void judge_pulse(Judge& judge, const Scene& scene, double width, std::optional<double> max_step) {
  HardMotion motion;
  motion.scene = scene;
  // events mark all pulses but those that need a longest step
  motion.step = max_step ? std::min(1e-3, *max_step) : 1e-3;
  motion.reference = ReferenceRun::stiff;  // rkf78 sees such loads by an estimate that is judged here
  motion.rounding = unit_roundoff<double>() / width;  // of the times at which it rises and falls
  motion.max_step = max_step;
  motion.starts = 4;  // a free body enlarges no difference of velocities
  judge.motion(motion);
}

void judge_near_parallel(Judge& judge, double start) {
  HardMotion motion;
  motion.scene = near_parallel(start);
  motion.exact = [start](MechanismState<double>& state) {
    const double half = (start + state.t) / 2;
    state.pose[0].p = {std::cos(half), 0, 0, std::sin(half)};
  };
  motion.reason = "driver \"drive\"";
  judge.motion(motion);
}

void judge_closing_distance(Judge& judge, double least) {
  HardMotion motion;
  motion.scene = closing_distance(least);
  motion.end = 2;
  // positions are known to u; close to the least distance d this is u / d of the speed f f' / r = 2 sqrt(d)
  motion.rounding = unit_roundoff<double>() / std::sqrt(std::max(least, unit_roundoff<double>()));
  motion.exact = [least](MechanismState<double>& state) {
    const double t = state.t, way = 1 - least;
    state.pose[0].r = {1 - 2 * way * t + way * t * t, 0, 0};
    state.twist[0].r_dot = {-2 * way + 2 * way * t, 0, 0};
  };
  motion.reason = "driver \"drive\"";
  judge.motion(motion);
}

void judge_infeasible(Judge& judge, double t) {
  judge_crank(judge, infeasible(t), judge.is_twin() ? 1 : std::max(1.0, 1.5 * t),
              "driver \"pull\" demands f = ");
}

}  // namespace

Family drivers() {
  return {"drivers",
          "sudden, fast and impossible drivers and loads",
          {{"jump_of_speed",
            "jump [rad/s]",
            {0, 1e3},
            0.1,
            {10},
            {1, 100},
            [](Judge& judge, double jump) {
              judge_crank(judge, jump_of_speed(jump), 0.5 + std::min(0.5, turned / jump));
            },
            jump_of_speed},
           {"jump_of_acceleration",
            "jump [rad/s^2]",
            {0, 1e3},
            1,
            {},
            {1e2, 1e3},
            [](Judge& judge, double jump) {
              judge_crank(judge, jump_of_acceleration(jump),
                          0.5 + std::min(0.5, std::sqrt(2 * turned / jump)));
            },
            jump_of_acceleration},
           {"fast_driver",
            "speed [rad/s]",
            {0.1, 1e6},
            2,
            {1000},
            {1000, 10000},
            [](Judge& judge, double speed) {
              judge_crank(judge, fast_driver(speed), std::min(1.0, turned / speed));
            },
            fast_driver},
           {"rectangular_pulse",
            "width [s]",
            {1e-9, 0.9},
            0.1,
            {1e-6},
            {1e-3, 1e-6, 1e-9},
            [](Judge& judge, double width) { judge_pulse(judge, rectangular_pulse(width), width, {}); },
            rectangular_pulse},
           {"smooth_pulse",
            "width [s]",
            {1e-7, 0.4},
            0.1,
            {},
            {1e-3, 1e-6},
            [](Judge& judge, double width) { judge_pulse(judge, smooth_pulse(width), width, {}); },
            smooth_pulse},
           {"unmarked_pulses",
            "width [s]; no step is longer than a half of it",
            {1e-4, 0.1},
            0.1,
            {1e-2},
            {1e-2, 1e-3},
            [](Judge& judge, double width) { judge_pulse(judge, unmarked_pulses(width), width, width / 2); },
            unmarked_pulses},
           {"near_parallel",
            "first angle between the vectors of a dp1 [rad]",
            {1e-8, 1.5},
            0.5,
            {1e-6},
            {1e-2, 1e-4, 1e-6, 1e-7},
            judge_near_parallel,
            near_parallel},
           {"closing_distance",
            "least distance of a driven d [m]",
            {0, 0.9},
            0.5,
            {1e-4},
            {1e-2, 1e-4, 1e-6, 0},
            judge_closing_distance,
            closing_distance},
           {"infeasible",
            "time at which no position is left [s]",
            {0.01, 100},
            10,
            {0.5},
            {0.1, 0.5, 0.9},
            judge_infeasible,
            infeasible}}};
}

}  // namespace trivium::hard
