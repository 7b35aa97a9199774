/// Drivers and loads that change suddenly or fast: jumps of f' and f'', fast drivers, pulses shorter than a
/// step, drivers that lose their grip, and one that demands too much.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "bodies/numbers/scalar.hpp"
#include "scenes/building.hpp"
#include "validation/hard/family.hpp"

namespace trivium::hard {

namespace {

using building::body, building::joint, building::side;
using scenes::Scene, scenes::Vector3;

const Vector3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

TimeFunction polynomial(std::vector<double> coefficients) {
  return TimeFunction(TimeFunction::Polynomial{std::move(coefficients)});
}

/// A crank of 1 m about z whose angle is driven, and on its tip a bar on a hinge along y, inclined to the
/// crank. It swings about the crank's direction when the crank turns fast.
Scene driven_crank(const std::string& name, const TimeFunction& angle) {
  Scene scene;
  scene.name = name;
  const double rate = angle(0.0).f_t, inclination = 0.5, c = std::cos(inclination), s = std::sin(inclination);
  scene.bodies = {body("crank", 1, {0.01, 0.1, 0.1}, {0.5, 0, 0}),
                  body("bar", 0.5, {0.005, 0.05, 0.05}, {1 + c / 2, 0, -s / 2})};
  scene.bodies[1].orientation = scenes::AxisAngle{y, inclination};
  scene.bodies[0].angular_velocity = {0, 0, rate};
  scene.bodies[0].velocity = {0, rate / 2, 0};
  scene.bodies[1].angular_velocity = {-rate * s, 0, rate * c};  // about the global z axis
  scene.bodies[1].velocity = {0, rate * (1 + c / 2), 0};
  scene.constraints = {
      joint(JointType::revolute, "axle", side(scenes::ground, Vector3{}, z, x),
            side(0, Vector3{-0.5, 0, 0}, z, x)),
      joint(JointType::rotation_driver, "drive", side(scenes::ground, {}, z, x), side(0, {}, z, x)),
      joint(JointType::revolute, "hinge", side(0, Vector3{0.5, 0, 0}, y), side(1, Vector3{-0.5, 0, 0}, y))};
  scene.constraints[1].angle = angle;
  scene.effects = {building::gravity()};
  return scene;
}

/// At 0.5 s the speed of the driver jumps by `jump` [rad/s].
Scene jump_of_speed(double jump) {
  return driven_crank(
      fmt::format("jump_of_speed_{:g}", jump),
      TimeFunction(TimeFunction::Piecewise{{0.5}, {polynomial({0, 1}), polynomial({-jump / 2, 1 + jump})}}));
}
/// At 0.5 s the acceleration of the driver jumps by `jump` [rad/s^2].
Scene jump_of_acceleration(double jump) {
  return driven_crank(fmt::format("jump_of_acceleration_{:g}", jump),
                      TimeFunction(TimeFunction::Piecewise{
                          {0.5}, {polynomial({0, 1}), polynomial({jump / 8, 1 - jump / 2, jump / 2})}}));
}
/// The driver turns at a constant speed [rad/s].
Scene fast_driver(double speed) {
  return driven_crank(fmt::format("fast_driver_{:g}", speed), polynomial({0, speed}));
}

void judge_crank(Judge& judge, const Scene& scene, double end = 1) {
  HardMotion motion;
  motion.scene = scene;
  motion.end = end;
  motion.step = end / 10000;
  judge.motion(motion);
}

/// A free body of 1 kg on which a force along x acts for `width` [s] around 0.5 s; its impulse is 1 N s.
Scene pulse(const std::string& name, const TimeFunction& force) {
  Scene scene;
  scene.name = name;
  scene.bodies = {body("puck", 1)};
  Force<double> load;
  load.body = 0;
  load.components = {force, TimeFunction(0), TimeFunction(0)};
  scene.effects = {load};
  return scene;
}
Scene rectangular_pulse(double width) {
  return pulse(
      fmt::format("rectangular_pulse_{:g}", width),
      TimeFunction(TimeFunction::Piecewise{{0.51 - width / 2, 0.51 + width / 2}, {0, 1 / width, 0}}));
}
/// Rises and falls by quintic steps of this width.
Scene smooth_pulse(double width) {
  const double middle = 0.51;
  return pulse(fmt::format("smooth_pulse_{:g}", width),
               TimeFunction(TimeFunction::Sum{{TimeFunction::Step5{middle - width, 0, middle, 1 / width},
                                               TimeFunction::Step5{middle, 0, middle + width, -1 / width}}}));
}
/// Pulses of 1 N s each, ten widths apart, that no event marks: powers of a cosine.
Scene unmarked_pulses(double width) {
  // cos^64(w t) is about exp(-32 w^2 t^2), whose integral is sqrt(pi / 32) / w; it returns after pi / w
  const double w = std::sqrt(std::numbers::pi / 32) / width;
  TimeFunction power{TimeFunction::Cos{{polynomial({0.5, w})}}};
  for (int k = 0; k < 6; ++k) power = TimeFunction(TimeFunction::Product{{power, power}});
  return pulse(fmt::format("unmarked_pulses_{:g}", width),
               TimeFunction(TimeFunction::Product{{1 / width, power}}));
}

void judge_pulse(Judge& judge, const Scene& scene, double width, std::optional<double> max_step) {
  HardMotion motion;
  motion.scene = scene;
  // events mark all pulses but those that need a longest step
  motion.step = max_step ? std::min(1e-3, *max_step) : 1e-3;
  motion.reference = ReferenceRun::stiff;  // the estimate of rkf78 does not see what depends on time alone
  motion.rounding = unit_roundoff<double>() / width;  // of the times at which it rises and falls
  motion.max_step = max_step;
  motion.starts = 4;  // a free body enlarges no difference of velocities
  motion.beside_simbody = !max_step;
  judge.motion(motion);
}

/// A wheel whose angle `start` + t is driven by a dp1 between two vectors, which have no grip at the angle 0.
Scene near_parallel(double start) {
  Scene scene;
  scene.name = fmt::format("near_parallel_{:g}", start);
  scene.bodies = {body("wheel", 1, {0.1, 0.1, 0.2})};
  scene.bodies[0].orientation = scenes::AxisAngle{z, start};
  scene.bodies[0].angular_velocity = {0, 0, 1};
  scene.constraints = {
      joint(JointType::revolute, "axle", side(scenes::ground, Vector3{}, z), side(0, Vector3{}, z)),
      joint(basic_type<DP1>, "drive", building::vector_side(scenes::ground, x), building::vector_side(0, x))};
  scene.constraints[1].f = TimeFunction(TimeFunction::Cos{{polynomial({start, 1})}});
  return scene;
}
void judge_near_parallel(Judge& judge, double start) {
  HardMotion motion;
  motion.scene = near_parallel(start);
  motion.exact = [start](MechanismState<double>& state) {
    const double half = (start + state.t) / 2;
    state.pose[0].p = {std::cos(half), 0, 0, std::sin(half)};
  };
  judge.motion(motion);
}

/// A slide along x whose distance from the ground is driven from 1 m to `least` and back, within 2 s. The row
/// d - L^2 has the gradient 2 L.
Scene closing_distance(double least) {
  Scene scene;
  scene.name = fmt::format("closing_distance_{:g}", least);
  const double way = 1 - least;
  scene.bodies = {body("slide", 1)};
  scene.bodies[0].position = {1, 0, 0};
  scene.bodies[0].velocity = {-2 * way, 0, 0};
  scene.constraints = {joint(JointType::translational, "guide", side(scenes::ground, Vector3{}, x, z),
                             side(0, Vector3{}, x, z)),
                       joint(basic_type<D>, "drive", side(scenes::ground, Vector3{}), side(0, Vector3{}))};
  const TimeFunction length = polynomial({1, -2 * way, way});
  scene.constraints[1].f = TimeFunction(TimeFunction::Product{{length, length}});
  return scene;
}
void judge_closing_distance(Judge& judge, double least) {
  HardMotion motion;
  motion.scene = closing_distance(least);
  motion.end = 2;
  motion.exact = [least](MechanismState<double>& state) {
    const double t = state.t, way = 1 - least;
    state.pose[0].r = {1 - 2 * way * t + way * t * t, 0, 0};
    state.twist[0].r_dot = {-2 * way + 2 * way * t, 0, 0};
  };
  judge.motion(motion);
}

/// Two links of 1 m, whose tip is driven away from the ground with constant speed; 2 m are reached at the
/// time `t`.
Scene infeasible(double t) {
  Scene scene;
  scene.name = fmt::format("infeasible_{:g}", t);
  // the elbow's position where the tip is at x = first
  const double first = 1, speed = (2 - first) / t, c = first / 2, s = std::sqrt(1 - c * c),
               rate = -speed / 2 / s;
  const double turn = std::acos(c);
  scene.bodies = {body("inner", 1, {0.01, 0.1, 0.1}, {c / 2, s / 2, 0}),
                  body("outer", 1, {0.01, 0.1, 0.1}, {1.5 * c, s / 2, 0})};
  scene.bodies[0].orientation = scenes::AxisAngle{z, turn};
  scene.bodies[1].orientation = scenes::AxisAngle{z, -turn};
  scene.bodies[0].angular_velocity = {0, 0, rate};
  scene.bodies[1].angular_velocity = {0, 0, -rate};
  scene.bodies[0].velocity = {-rate * s / 2, rate * c / 2, 0};
  scene.bodies[1].velocity = {-1.5 * rate * s, rate * c / 2, 0};
  const Vector3 back{-0.5, 0, 0}, front{0.5, 0, 0};
  scene.constraints = {
      joint(JointType::revolute, "shoulder", side(scenes::ground, Vector3{}, z), side(0, back, z)),
      joint(JointType::revolute, "elbow", side(0, front, z), side(1, back, z)),
      joint(basic_type<D>, "pull", side(scenes::ground, Vector3{}), side(1, front))};
  scene.constraints[2].f = polynomial({first * first, 2 * first * speed, speed * speed});
  scene.effects = {Gravity<double>{"", {0, -9.81, 0}}};
  return scene;
}

}  // namespace

Family drivers() {
  const auto crank = [](Scene (*make)(double)) {
    return [make](Judge& judge, double jump) { judge_crank(judge, make(jump)); };
  };
  return {"drivers",
          "sudden, fast and impossible drivers and loads",
          {{"jump_of_speed", "jump [rad/s]", 0.1, {10}, {1, 10, 100}, crank(jump_of_speed), jump_of_speed},
           {"jump_of_acceleration",
            "jump [rad/s^2]",
            1,
            {},
            {1e2, 1e3},
            crank(jump_of_acceleration),
            jump_of_acceleration},
           {"fast_driver",
            "speed [rad/s]",
            2,
            {1000},
            {100, 1000, 10000},
            [](Judge& judge, double speed) {
              judge_crank(judge, fast_driver(speed), std::min(1.0, 100 / speed));
            },
            fast_driver},
           {"rectangular_pulse",
            "width [s]",
            0.1,
            {1e-6},
            {1e-3, 1e-6, 1e-9},
            [](Judge& judge, double width) { judge_pulse(judge, rectangular_pulse(width), width, {}); },
            rectangular_pulse},
           {"smooth_pulse",
            "width [s]",
            0.1,
            {},
            {1e-3, 1e-6},
            [](Judge& judge, double width) { judge_pulse(judge, smooth_pulse(width), width, {}); },
            smooth_pulse},
           {"unmarked_pulses",
            "width [s]; no step is longer than a half of it",
            0.1,
            {1e-3},
            {1e-3, 1e-4},
            [](Judge& judge, double width) { judge_pulse(judge, unmarked_pulses(width), width, width / 2); },
            unmarked_pulses},
           {"near_parallel",
            "first angle between the vectors of a dp1 [rad]",
            0.5,
            {1e-6},
            {1e-2, 1e-4, 1e-6, 1e-7},
            judge_near_parallel,
            near_parallel},
           {"closing_distance",
            "least distance of a driven d [m]",
            0.5,
            {1e-4},
            {1e-2, 1e-4, 1e-6, 0},
            judge_closing_distance,
            closing_distance},
           {"infeasible",
            "time at which no position is left [s]",
            10,
            {0.5},
            {0.1, 0.5, 0.9},
            [](Judge& judge, double t) { judge_crank(judge, infeasible(t)); },
            infeasible}}};
}

}  // namespace trivium::hard
