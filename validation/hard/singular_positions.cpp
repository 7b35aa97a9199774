/// Positions where rows lose rank: a flat parallelogram, a rod as long as its crank, the N-four-bar.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "scenes/building.hpp"
#include "scenes/generators.hpp"
#include "validation/hard/family.hpp"

namespace trivium::hard {

namespace {

using building::body, building::joint, building::side;
using scenes::Scene, scenes::Vector3;

const Vector3 z{0, 0, 1};

/// The pose and twist of a body that turns about the global z axis.
void set(MechanismState<double>& state, int b, double x, double y, double angle, double x_dot, double y_dot,
         double rate) {
  state.pose[b] = {{x, y, 0}, {std::cos(angle / 2), 0, 0, std::sin(angle / 2)}};
  state.twist[b] = {{x_dot, y_dot, 0}, {0, 0, rate}};
}

void set(Scene& scene, const MechanismState<double>& state) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const auto& [r, p] = state.pose[b];
    const auto& [v, omega_bar] = state.twist[b];
    scene.bodies[b].position = {r[0], r[1], r[2]};
    scene.bodies[b].orientation = scenes::EulerParameters{{p[0], p[1], p[2], p[3]}};
    scene.bodies[b].velocity = {v[0], v[1], v[2]};
    scene.bodies[b].angular_velocity = {omega_bar[0], omega_bar[1], omega_bar[2]};
  }
}

MechanismState<double> empty_state(std::size_t bodies) {
  MechanismState<double> state;
  state.pose.resize(bodies);
  state.twist.resize(bodies);
  return state;
}

/// Two cranks of length 1 m and a coupler of this length; all cranks turn at 3 rad/s, without gravity.
void set_parallelogram(MechanismState<double>& state, double coupler) {
  const double theta = 1 + 3 * state.t, c = std::cos(theta), s = std::sin(theta), rate = 3;
  set(state, 0, c / 2, s / 2, theta, -rate * s / 2, rate * c / 2, rate);
  set(state, 1, coupler + c / 2, s / 2, theta, -rate * s / 2, rate * c / 2, rate);
  set(state, 2, coupler / 2 + c, s, 0, -rate * s, rate * c, 0);
}

Scene flat_parallelogram(double coupler) {
  Scene scene;
  scene.name = fmt::format("flat_parallelogram_{:g}", coupler);
  const double J = 1.0 / 12;
  scene.bodies = {body("left", 1, {0.01, J, J}), body("right", 1, {0.01, J, J}),
                  body("coupler", 1, {0.01, coupler * coupler * J, coupler * coupler * J})};
  MechanismState<double> start = empty_state(3);
  set_parallelogram(start, coupler);
  set(scene, start);
  const Vector3 back{-0.5, 0, 0}, front{0.5, 0, 0}, left{-coupler / 2, 0, 0}, right{coupler / 2, 0, 0};
  scene.constraints = {
      joint(JointType::revolute, "A", side(scenes::ground, Vector3{}, z), side(0, back, z)),
      joint(JointType::revolute, "B", side(0, front, z), side(2, left, z)),
      joint(JointType::revolute, "C", side(2, right, z), side(1, front, z)),
      joint(JointType::revolute, "D", side(scenes::ground, Vector3{coupler, 0, 0}, z), side(1, back, z))};
  return scene;
}

void judge_parallelogram(Judge& judge, double coupler) {
  HardMotion motion;
  motion.scene = flat_parallelogram(coupler);
  // the easy twin ends before the flat position
  motion.end = judge.is_twin() ? 0.5 : judge.is_quick() ? 5 : 20;
  motion.step = 2e-3;
  motion.exact = [coupler](MechanismState<double>& state) { set_parallelogram(state, coupler); };
  judge.motion(motion);
}

/// The sum of m v^2 and J omega^2 of crank and rod, both 1 kg and 1 m, per square of the crank's speed, where
/// the crank's angle is theta: the rod's end slides along the x axis.
double inertia_at(double theta) {
  const double s2 = std::sin(theta) * std::sin(theta);
  return (0.1 + 0.25) + (0.1 + 2.25 * s2 + 0.25 * (1 - s2));
}

constexpr double first_angle = 0.3;

/// Crank and rod after the crank has turned from its first angle, where its speed was `rate`. The kinetic
/// energy does not change. By Runge-Kutta steps of order 4, far shorter than needed.
void set_crank(MechanismState<double>& state, double rate) {
  const double momentum = std::sqrt(inertia_at(first_angle)) * rate;
  const auto speed = [&](double theta) { return momentum / std::sqrt(inertia_at(theta)); };
  double theta = first_angle;
  const int steps = 1 + static_cast<int>(4000 * state.t);
  const double h = state.t / steps;
  for (int n = 0; n < steps; ++n) {
    const double k1 = speed(theta), k2 = speed(theta + h / 2 * k1), k3 = speed(theta + h / 2 * k2),
                 k4 = speed(theta + h * k3);
    theta += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  const double c = std::cos(theta), s = std::sin(theta), omega = speed(theta);
  set(state, 0, c / 2, s / 2, theta, -omega * s / 2, omega * c / 2, omega);
  set(state, 1, 1.5 * c, s / 2, -theta, -1.5 * omega * s, omega * c / 2, -omega);
}

/// Where the rod lies on the crank, both could also turn together.
Scene rod_on_crank(double rate) {
  Scene scene;
  scene.name = fmt::format("rod_on_crank_{:g}", rate);
  scene.bodies = {body("crank", 1, {0.02, 0.1, 0.1}), body("rod", 1, {0.02, 0.1, 0.1})};
  MechanismState<double> start = empty_state(2);
  set_crank(start, rate);
  set(scene, start);
  const Vector3 back{-0.5, 0, 0}, front{0.5, 0, 0};
  scene.constraints = {joint(JointType::revolute, "A", side(scenes::ground, Vector3{}, z), side(0, back, z)),
                       joint(JointType::revolute, "B", side(0, front, z), side(1, back, z)),
                       joint(basic_type<CD>, "slide", side(scenes::ground, Vector3{}), side(1, front))};
  scene.constraints.back().direction = {0, 1, 0};
  return scene;
}

void judge_rod_on_crank(Judge& judge, double rate) {
  HardMotion motion;
  motion.scene = rod_on_crank(rate);
  // the easy twin ends before the dead point
  motion.end = judge.is_twin() ? 0.3 : judge.is_quick() ? 5 : 20;
  motion.step = 2e-3;
  motion.exact = [rate](MechanismState<double>& state) { set_crank(state, rate); };
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
  const double c = std::cos(theta), s = std::sin(theta), turn = theta - std::numbers::pi / 2;
  for (int k = 0; k <= n; ++k) set(state, k, k + c / 2, s / 2, turn, -rate * s / 2, rate * c / 2, rate);
  for (int k = 1; k <= n; ++k) set(state, n + k, k - 0.5 + c, s, 0, -rate * s, rate * c, 0);
}

void judge_four_bars(Judge& judge, double loops) {
  const int n = static_cast<int>(loops);
  HardMotion motion;
  motion.scene = scenes::ladder(n);
  motion.end = judge.is_twin() ? 0.4 : judge.is_quick() ? 3 : 20;
  motion.step = 2e-3;
  motion.exact = [n](MechanismState<double>& state) { set_four_bars(state, n); };
  // 81 bodies for 20 s: methods of low order would take an hour
  if (n > 10 && !judge.is_twin()) motion.methods = {"dopri5", "rkf78", "radau5", "radau9"};
  judge.motion(motion);
}

}  // namespace

Family singular_positions() {
  return {
      "singular_positions",
      "positions where rows lose rank",
      {{"flat_parallelogram",
        "length of the coupler [m]",
        2.5,
        {2},
        {0.1, 1, 2, 10},
        judge_parallelogram,
        flat_parallelogram},
       {"rod_on_crank", "speed of the crank [rad/s]", 1, {3}, {0.3, 3, 30}, judge_rod_on_crank, rod_on_crank},
       {"four_bars", "number of loops", 1, {1}, {1, 2, 40}, judge_four_bars, [](double n) {
          return scenes::ladder(static_cast<int>(n));
        }}}};
}

}  // namespace trivium::hard
