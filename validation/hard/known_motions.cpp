#include "validation/hard/known_motions.hpp"

#include <fmt/format.h>

#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <numbers>
#include <variant>

#include "scenes/building.hpp"
#include "scenes/scene_state.hpp"

namespace trivium::hard {

using building::body, building::joint, building::side;
using scenes::Scene, scenes::Vector3;

// by the arithmetic-geometric mean
double complete_elliptic_integral(double complementary_modulus) {
  double x = 1, y = complementary_modulus;
  for (int k = 0; k < 8; ++k) {
    const double mean = (x + y) / 2;
    y = std::sqrt(x * y);
    x = mean;
  }
  return std::numbers::pi / 2 / x;
}

// The cosine u of the inclination satisfies u'^2 = (b^2 - beta u)(1 - u^2) - (b - a u)^2, whose right side is
// a cubic with the root 0 (Goldstein, Classical Mechanics, 5.7).
double height_of_top(double spin, double t) {
  const double A = 15 + 0.234375, a = 0.46875 * spin / A, b = -4.61538, beta = 2 * 15 * 9.81 / A,
               sum = (a * a + b * b) / beta, product = 2 * a * b / beta - 1,
               above = sum / 2 + std::sqrt(sum * sum / 4 - product), below = product / above;
  double cn, dn;
  boost::math::jacobi_elliptic(std::sqrt(-below / (above - below)), std::sqrt(beta * (above - below)) / 2 * t,
                               &cn, &dn);
  return below * (1 - cn * cn / (dn * dn));
}

// half of 4 K(k) / p (Landau and Lifshitz, Mechanics, 37)
double time_of_a_flip(const scenes::Body& body) {
  const auto& J = std::get<Vector3>(body.inertia);
  const Vector3& w = body.angular_velocity;
  const double above = J[0] * (J[0] - J[1]) * w[0] * w[0] + J[2] * (J[2] - J[1]) * w[2] * w[2],
               from_least = J[1] * (J[1] - J[0]) * w[1] * w[1] + J[2] * (J[2] - J[0]) * w[2] * w[2];
  const double K =
      complete_elliptic_integral(std::sqrt((J[2] - J[0]) * above / ((J[2] - J[1]) * from_least)));
  return 2 * K / std::sqrt((J[2] - J[1]) * from_least / (J[0] * J[1] * J[2]));
}

void set_in_plane(MechanismState<double>& state, int body, double x, double y, double angle, double x_dot,
                  double y_dot, double rate) {
  state.pose[body] = {{x, y, 0}, {std::cos(angle / 2), 0, 0, std::sin(angle / 2)}};
  state.twist[body] = {{x_dot, y_dot, 0}, {0, 0, rate}};
}

MechanismState<double> state_of_size(std::size_t bodies) {
  MechanismState<double> state;
  state.pose.resize(bodies);
  state.twist.resize(bodies);
  return state;
}

namespace {

/// The sum of m v^2 and J omega^2 of crank and rod, both of 1 kg, per square of the crank's speed.
double inertia_at(double theta) {
  const double s2 = std::sin(theta) * std::sin(theta);
  return (0.1 + 0.25) + (0.1 + 2.25 * s2 + 0.25 * (1 - s2));
}

}  // namespace

Scene rod_on_crank(double rate) {
  const Vector3 z{0, 0, 1}, back{-0.5, 0, 0}, front{0.5, 0, 0};
  Scene scene;
  scene.name = fmt::format("rod_on_crank_{:g}", rate);
  scene.bodies = {body("crank", 1, {0.02, 0.1, 0.1}), body("rod", 1, {0.02, 0.1, 0.1})};
  MechanismState<double> start = state_of_size(2);
  set_rod_on_crank(start, rate);
  set_state(scene, start);
  scene.constraints = {joint(JointType::revolute, "A", side(scenes::ground, Vector3{}, z), side(0, back, z)),
                       joint(JointType::revolute, "B", side(0, front, z), side(1, back, z)),
                       joint(basic_type<CD>, "slide", side(scenes::ground, Vector3{}), side(1, front))};
  scene.constraints.back().direction = {0, 1, 0};
  return scene;
}

// The kinetic energy does not change. By Runge-Kutta steps of order 4, far shorter than needed.
void set_rod_on_crank(MechanismState<double>& state, double rate) {
  double theta = 0.3;
  const double momentum = std::sqrt(inertia_at(theta)) * rate;
  const auto speed = [&](double angle) { return momentum / std::sqrt(inertia_at(angle)); };
  const int steps = 1 + static_cast<int>(4000 * state.t);
  const double h = state.t / steps;
  for (int n = 0; n < steps; ++n) {
    const double k1 = speed(theta), k2 = speed(theta + h / 2 * k1), k3 = speed(theta + h / 2 * k2),
                 k4 = speed(theta + h * k3);
    theta += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  const double c = std::cos(theta), s = std::sin(theta), omega = speed(theta);
  set_in_plane(state, 0, c / 2, s / 2, theta, -omega * s / 2, omega * c / 2, omega);
  set_in_plane(state, 1, 1.5 * c, s / 2, -theta, -1.5 * omega * s, omega * c / 2, -omega);
}

Scene stone_on_spring(double stiffness, double damping, double free_length, double velocity) {
  Scene scene;
  scene.name = fmt::format("stone_{:g}", stiffness);
  scene.bodies = {body("stone", 1, {0.1, 0.1, 0.1}, {1, 0, 0})};
  scene.bodies[0].velocity = {0, velocity, 0};
  SpringDamper<double> spring;
  spring.i.body = scenes::ground;
  spring.j.body = 0;
  spring.stiffness = stiffness;
  spring.damping = damping;
  spring.free_length = free_length;
  scene.effects = {spring};
  return scene;
}

namespace {

constexpr double orbital_speed = 10;  // [rad/s]

}  // namespace

Scene orbit_on_spring(double stiffness, double damping) {
  return stone_on_spring(stiffness, damping, 1 - orbital_speed * orbital_speed / stiffness, orbital_speed);
}

void set_orbit(MechanismState<double>& state) {
  const double c = std::cos(orbital_speed * state.t), s = std::sin(orbital_speed * state.t);
  state.pose[0].r = {c, s, 0};
  state.twist[0].r_dot = {-orbital_speed * s, orbital_speed * c, 0};
}

}  // namespace trivium::hard
