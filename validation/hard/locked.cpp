/// Bodies that cannot move, alone and beside others, and equilibria that must be held.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bodies/numbers/scalar.hpp"
#include "scenes/building.hpp"
#include "scenes/generators.hpp"
#include "validation/hard/family.hpp"

namespace trivium::hard {

namespace {

using building::body, building::joint, building::side;
using scenes::Scene, scenes::Vector3;

/// A body on three pins to the ground, the last of which misses the line of the others by `off` [m].
Scene held_body(double off) {
  Scene scene;
  scene.name = fmt::format("held_body_{:g}", off);
  scene.bodies = {body("held", 1, {0.1, 0.2, 0.15}, {1, 0, 0})};
  for (const Vector3& p : {Vector3{-1, 0, 0}, Vector3{-1, 0, 1}, Vector3{-1, off, 2}})
    scene.constraints.push_back(joint(JointType::spherical, fmt::format("pin {:g}", p[2]),
                                      side(scenes::ground, Vector3{p[0] + 1, p[1], p[2]}), side(0, p)));
  scene.effects = {Gravity<double>{"", {0, -9.81, 0}}};
  return scene;
}

constexpr double away = 5;  ///< from the origin to the pendulum [m]

/// The held body beside a pendulum whose mass and size are this ratio of its own.
Scene beside_a_pendulum(double ratio) {
  Scene scene = held_body(0.1);
  scene.name = fmt::format("beside_a_pendulum_{:g}", ratio);
  const double mass = ratio, length = ratio, J = 0.1 * mass * length * length;
  scene.bodies.push_back(body("bob", mass, {J, 2 * J, 1.5 * J}, {away + length, 0, 0}));
  scene.constraints.push_back(joint(JointType::spherical, "pivot", side(scenes::ground, Vector3{away, 0, 0}),
                                    side(1, Vector3{-length, 0, 0})));
  return scene;
}

/// A chain of bars that hangs straight down.
Scene hanging_chain(double bars) {
  Scene scene;
  scene.name = fmt::format("hanging_chain_{:g}", bars);
  const Vector3 y{0, 1, 0};
  for (int k = 0; k < static_cast<int>(bars); ++k) {
    scene.bodies.push_back(body(fmt::format("bar_{}", k + 1), 1, {0.1, 0.1, 0.01}, {0, 0, -0.5 - k}));
    scene.constraints.push_back(
        joint(JointType::revolute, fmt::format("J{}", k + 1),
              side(k == 0 ? scenes::ground : k - 1, k == 0 ? Vector3{} : Vector3{0, 0, -0.5}, y),
              side(k, Vector3{0, 0, 0.5}, y)));
  }
  scene.effects = {building::gravity()};
  return scene;
}

constexpr double plate_mass = 3, g = 9.81;

/// A plate that hangs at rest on three vertical springs of this stiffness [N/m].
Scene sprung_plate(double stiffness) {
  Scene scene;
  scene.name = fmt::format("sprung_plate_{:g}", stiffness);
  constexpr double length = 1;
  scene.bodies = {body("plate", plate_mass, {0.3, 0.3, 0.6})};
  for (const auto& [x, y] : {std::pair(0.5, 0.0), {-0.25, 0.4}, {-0.25, -0.4}}) {
    SpringDamper<double> spring;
    spring.name = fmt::format("spring_{}", scene.effects.size() + 1);
    spring.i = {scenes::ground, {x, y, length}};
    spring.j = {0, {x, y, 0}};
    spring.stiffness = stiffness;
    spring.free_length = length - plate_mass * g / (3 * stiffness);
    scene.effects.push_back(spring);
  }
  scene.effects.push_back(building::gravity(g));
  return scene;
}

/// A motion that is none: the state stays as it is.
HardMotion rest(const Scene& scene, double end, double step) {
  HardMotion motion;
  motion.scene = scene;
  motion.end = end;
  motion.step = step;
  motion.exact = [](MechanismState<double>&) {};
  motion.monitor = Monitor::positions;  // there is no speed to which velocities could be relative
  return motion;
}

/// Below the rank tolerance the pins are on a line, about which the body swings.
void judge_held_body(Judge& judge, double off) {
  constexpr double in_line = 1e-8;
  HardMotion motion;
  motion.scene = held_body(off);
  if (off >= in_line) {
    motion = rest(motion.scene, 1, 1e-2);
    motion.rounding = unit_roundoff<double>() / std::min(off, 1.0);  // of the angle about the line
  }
  // the share of the last pin's rows is a quarter of `off`; two decades beside the rank tolerance are narrow
  if (off > in_line / 25 && off < 100 * in_line) motion.reason = "by a narrow margin";
  judge.motion(motion);
}

void judge_beside(Judge& judge, double ratio) {
  HardMotion motion;
  motion.scene = beside_a_pendulum(ratio);
  motion.end = std::sqrt(ratio);
  motion.step = motion.end / 1000;
  motion.length = ratio;  // of what moves
  motion.rounding = unit_roundoff<double>() * away / ratio;
  judge.motion(motion);
}

}  // namespace

Family locked() {
  return {"locked",
          "bodies that cannot move, and equilibria",
          {{"held_body",
            "by how much a third pin misses a line [m]",
            {0, 10},
            1,
            {1e-3, 1e-6},
            {1e-1, 1e-3, 1e-5, 1e-6, 3e-7, 3e-8, 1e-9, 0},
            judge_held_body,
            held_body},
           {"beside_a_pendulum",
            "size and mass of a pendulum beside it",
            {1e-6, 1e6},
            1,
            {1e-3},
            {1e-3, 1e-2, 1e2, 1e3},
            judge_beside,
            beside_a_pendulum},
           {"hanging_chain",
            "number of bars that hang at rest",
            {1, 10, true},
            1,
            {},
            {3},
            [](Judge& judge, double bars) {
              judge.motion(rest(hanging_chain(bars), judge.is_twin() ? 100 : 1000, 0.05));
            },
            hanging_chain},
           {"sprung_plate",
            "stiffness of the three springs on which a plate hangs at rest [N/m]",
            {30, 1e5},
            30,
            {},
            {100},
            [](Judge& judge, double stiffness) {
              const double omega = std::sqrt(3 * stiffness / plate_mass);
              judge.motion(
                  rest(sprung_plate(stiffness), judge.is_twin() ? 100 : 1000, std::min(0.05, 0.5 / omega)));
            },
            sprung_plate}}};
}

}  // namespace trivium::hard
