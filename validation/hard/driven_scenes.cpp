#include "validation/hard/driven_scenes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "scenes/building.hpp"

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

/// A free body of 1 kg on which a force along x acts.
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

}  // namespace

Scene jump_of_speed(double jump) {
  return driven_crank(
      fmt::format("jump_of_speed_{:g}", jump),
      TimeFunction(TimeFunction::Piecewise{{0.5}, {polynomial({0, 1}), polynomial({-jump / 2, 1 + jump})}}));
}

Scene jump_of_acceleration(double jump) {
  return driven_crank(fmt::format("jump_of_acceleration_{:g}", jump),
                      TimeFunction(TimeFunction::Piecewise{
                          {0.5}, {polynomial({0, 1}), polynomial({jump / 8, 1 - jump / 2, jump / 2})}}));
}

Scene fast_driver(double speed) {
  return driven_crank(fmt::format("fast_driver_{:g}", speed), polynomial({0, speed}));
}

Scene rectangular_pulse(double width) {
  return pulse(
      fmt::format("rectangular_pulse_{:g}", width),
      TimeFunction(TimeFunction::Piecewise{{0.51 - width / 2, 0.51 + width / 2}, {0, 1 / width, 0}}));
}

Scene smooth_pulse(double width) {
  const double middle = 0.51;
  return pulse(fmt::format("smooth_pulse_{:g}", width),
               TimeFunction(TimeFunction::Sum{{TimeFunction::Step5{middle - width, 0, middle, 1 / width},
                                               TimeFunction::Step5{middle, 0, middle + width, -1 / width}}}));
}

Scene unmarked_pulses(double width) {
  // cos^64(w t) is about exp(-32 w^2 t^2), whose integral is sqrt(pi / 32) / w; it returns after pi / w
  const double w = std::sqrt(std::numbers::pi / 32) / width;
  TimeFunction power{TimeFunction::Cos{{polynomial({0.5, w})}}};
  for (int k = 0; k < 6; ++k) power = TimeFunction(TimeFunction::Product{{power, power}});
  return pulse(fmt::format("unmarked_pulses_{:g}", width),
               TimeFunction(TimeFunction::Product{{1 / width, power}}));
}

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

}  // namespace trivium::hard
