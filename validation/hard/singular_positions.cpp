/// Positions where rows lose rank: a flat parallelogram, a rod as long as its crank, the N-four-bar.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "bodies/numbers/scalar.hpp"
#include "scenes/building.hpp"
#include "scenes/generators.hpp"
#include "scenes/scene_state.hpp"
#include "validation/hard/family.hpp"
#include "validation/hard/known_motions.hpp"
#include "validation/hard/methods.hpp"

namespace trivium::hard {

namespace {

using building::body, building::joint, building::side;
using scenes::Scene, scenes::Vector3;

const Vector3 z{0, 0, 1};

/// Two cranks of length 1 m and a coupler of this length; all cranks turn at 3 rad/s, without gravity.
void set_parallelogram(MechanismState<double>& state, double coupler) {
  const double theta = 1 + 3 * state.t, c = std::cos(theta), s = std::sin(theta), rate = 3;
  set_in_plane(state, 0, c / 2, s / 2, theta, -rate * s / 2, rate * c / 2, rate);
  set_in_plane(state, 1, coupler + c / 2, s / 2, theta, -rate * s / 2, rate * c / 2, rate);
  set_in_plane(state, 2, coupler / 2 + c, s, 0, -rate * s, rate * c, 0);
}

/// The angle [rad] of a body that moves in the plane z = 0, but for full turns.
double angle_in_plane(const MechanismState<double>& state, int body) {
  const auto& p = state.pose[body].p;
  return 2 * std::atan2(p[3], p[0]);
}

bool are_equal_angles(double a, double b) {
  return std::abs(std::remainder(a - b, 2 * std::numbers::pi)) <= small_difference;
}

/// The branch of parallelograms, whose first bodies are the cranks.
Branch parallel_cranks(int cranks) {
  return {"all cranks are parallel", [cranks](const MechanismState<double>& state) {
            for (int k = 1; k < cranks; ++k)
              if (!are_equal_angles(angle_in_plane(state, k), angle_in_plane(state, 0))) return false;
            return true;
          }};
}

Scene flat_parallelogram(double coupler) {
  Scene scene;
  scene.name = fmt::format("flat_parallelogram_{:g}", coupler);
  const double J = 1.0 / 12, across = coupler * coupler * J;
  scene.bodies = {body("left", 1, {0.01, J, J}), body("right", 1, {0.01, J, J}),
                  body("coupler", 1, {std::min(0.01, 0.12 * across), across, across})};
  MechanismState<double> start = state_of_size(3);
  set_parallelogram(start, coupler);
  set_state(scene, start);
  const Vector3 back{-0.5, 0, 0}, front{0.5, 0, 0}, left{-coupler / 2, 0, 0}, right{coupler / 2, 0, 0};
  scene.constraints = {
      joint(JointType::revolute, "A", side(scenes::ground, Vector3{}, z), side(0, back, z)),
      joint(JointType::revolute, "B", side(0, front, z), side(2, left, z)),
      joint(JointType::revolute, "C", side(2, right, z), side(1, front, z)),
      joint(JointType::revolute, "D", side(scenes::ground, Vector3{coupler, 0, 0}, z), side(1, back, z))};
  return scene;
}

HardMotion motion_of_parallelogram(double coupler) {
  HardMotion motion;
  motion.scene = flat_parallelogram(coupler);
  motion.reason = "singular position";
  motion.step = 2e-3;
  motion.exact = [coupler](MechanismState<double>& state) { set_parallelogram(state, coupler); };
  motion.branch = parallel_cranks(2);
  return motion;
}

void judge_parallelogram(Judge& judge, double coupler) {
  HardMotion motion = motion_of_parallelogram(coupler);
  motion.sums_hold = judge.is_twin();
  // the easy twin ends before the flat position
  motion.end = judge.is_twin() ? 0.5 : judge.is_quick() ? 5 : 20;
  judge.motion(motion);
}

HardMotion motion_of_rod_on_crank(double rate) {
  HardMotion motion;
  motion.scene = rod_on_crank(rate);
  motion.reason = "singular position";
  motion.exact = [rate](MechanismState<double>& state) { set_rod_on_crank(state, rate); };
  motion.branch = {"the rod turns against the crank", [](const MechanismState<double>& state) {
                     return are_equal_angles(angle_in_plane(state, 1), -angle_in_plane(state, 0));
                   }};
  return motion;
}

void judge_rod_on_crank(Judge& judge, double rate) {
  HardMotion motion = motion_of_rod_on_crank(rate);
  motion.sums_hold = judge.is_twin();
  // the easy twin ends before the dead point; a fast crank turns as often as one of 3 rad/s
  const double faster = std::max(1.0, rate / 3);
  motion.end = judge.is_twin() ? 0.3 : (judge.is_quick() ? 5 : 20) / faster;
  motion.step = 2e-3 / faster;
  judge.motion(motion);
}

/// The rods' angle [rad] and speed of the N-four-bar at time t: a pendulum of one degree of freedom that
/// starts upright. By Runge-Kutta steps of order 4.
std::pair<double, double> angle_of_four_bars(double n, double t) {
  const double ratio = 9.81 * ((n + 1) / 2 + n) / ((n + 1) / 3 + n);
  const auto acceleration = [&](double theta) { return -ratio * std::cos(theta); };
  double theta = std::numbers::pi / 2, rate = -1;
  const int steps = 1 + static_cast<int>(4000 * t);
  const double h = t / steps;
  for (int k = 0; k < steps; ++k) {
    const double v1 = rate, a1 = acceleration(theta), v2 = rate + h / 2 * a1,
                 a2 = acceleration(theta + h / 2 * v1), v3 = rate + h / 2 * a2,
                 a3 = acceleration(theta + h / 2 * v2), v4 = rate + h * a3, a4 = acceleration(theta + h * v3);
    theta += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    rate += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return {theta, rate};
}

void set_four_bars(MechanismState<double>& state, int n) {
  const auto [theta, rate] = angle_of_four_bars(n, state.t);
  set_ladder(state, n, theta, rate);
}

HardMotion motion_of_four_bars(int n) {
  HardMotion motion;
  motion.scene = scenes::ladder(n);
  motion.reason = "singular position";
  motion.step = 2e-3;
  motion.exact = [n](MechanismState<double>& state) { set_four_bars(state, n); };
  motion.branch = parallel_cranks(n + 1);
  return motion;
}

void judge_four_bars(Judge& judge, double loops) {
  const int n = static_cast<int>(loops);
  HardMotion motion = motion_of_four_bars(n);
  motion.sums_hold = judge.is_twin();
  motion.end = judge.is_twin() ? 0.4 : judge.is_quick() ? 3 : 20;
  if (n > 10 && !judge.is_twin()) {
    motion.methods = methods_of("singular_positions/large_four_bars", judge.is_quick());
    motion.starts = 4;
    motion.beside_simbody = false;
  }
  judge.motion(motion);
}

/// All three with tight tolerances, by methods that have ended there.
void judge_tight(Judge& judge, double rtol) {
  for (const auto& [part, motion_of_part] : {std::pair("parallelogram", motion_of_parallelogram(2)),
                                             std::pair("rod_on_crank", motion_of_rod_on_crank(3)),
                                             std::pair("four_bars", motion_of_four_bars(2))}) {
    judge.begin_part(part);
    HardMotion motion = motion_of_part;
    // the easy twin ends before the first singular position
    motion.end = judge.is_twin() ? 0.4 : 5;
    motion.rtol = rtol;
    motion.gives_steps = false;
    motion.rounding = std::sqrt(unit_roundoff<double>());  // rows of rank less by one fix no more digits
    motion.methods = methods_of("tight_tolerances", judge.is_quick());
    motion.beside_simbody = false;
    judge.motion(motion);
  }
}

}  // namespace

Family singular_positions() {
  return {"singular_positions",
          "positions where rows lose rank",
          {{"flat_parallelogram",
            "length of the coupler [m]",
            {0.01, 100},
            2.5,
            {2},
            {0.1, 1, 100},
            judge_parallelogram,
            flat_parallelogram},
           {"rod_on_crank",
            "speed of the crank [rad/s]",
            {0.01, 1000},
            1,
            {3},
            {0.3, 3, 30},
            judge_rod_on_crank,
            rod_on_crank},
           {"four_bars",
            "number of loops",
            {1, 100, true},
            1,
            {1},
            {1, 2, 40},
            judge_four_bars,
            [](double n) { return scenes::ladder(static_cast<int>(n)); }},
           {"tight_tolerances",
            "rtol of methods that have ended at singular positions",
            {1e-12, 1e-6},
            1e-6,
            {1e-10},
            {1e-9, 1e-10, 1e-12},
            judge_tight}}};
}

}  // namespace trivium::hard
