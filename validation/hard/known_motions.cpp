#include "validation/hard/known_motions.hpp"

#include <fmt/format.h>

#include <boost/math/special_functions/ellint_1.hpp>
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

namespace {

/// The solution of Euler's equations for J_0 < J_1 < J_2 and M^2 > 2 E J_1 (Landau and Lifshitz, Mechanics,
/// 37): omega = (a_0 cn, a_1 sn, a_2 dn) of the argument p t, with the modulus k.
struct Flips {
  Vector3 amplitude;
  double p, k, complement;  ///< complement: sqrt(1 - k^2)

  explicit Flips(const scenes::Body& body) {
    const auto& J = std::get<Vector3>(body.inertia);
    const Vector3& w = body.angular_velocity;
    // M^2 - 2 E J_n, without cancellation
    const auto apart_from = [&](int n) {
      double sum = 0;
      for (int i = 0; i < 3; ++i) sum += J[i] * (J[i] - J[n]) * w[i] * w[i];
      return sum;
    };
    const double least = apart_from(0), middle = apart_from(1), largest = -apart_from(2);
    amplitude = {std::sqrt(largest / (J[0] * (J[2] - J[0]))), std::sqrt(largest / (J[1] * (J[2] - J[1]))),
                 std::sqrt(least / (J[2] * (J[2] - J[0])))};
    p = std::sqrt((J[2] - J[1]) * least / (J[0] * J[1] * J[2]));
    k = std::sqrt((J[1] - J[0]) * largest / ((J[2] - J[1]) * least));
    complement = std::sqrt((J[2] - J[0]) * middle / ((J[2] - J[1]) * least));
  }
};

}  // namespace

double time_of_a_flip(const scenes::Body& body) {
  const Flips flips(body);
  return 2 * complete_elliptic_integral(flips.complement) / flips.p;  // a half of the period 4 K(k) / p
}

Vector3 angular_velocity_of_flips(const scenes::Body& body, double t) {
  const Flips flips(body);
  const Vector3 &a = flips.amplitude, &w = body.angular_velocity;
  const double sign = w[2] < 0 ? -1 : 1;  // dn is positive; -w_0 and -w_2 solve the equations, too
  const double first = boost::math::ellint_1(flips.k, std::atan2(w[1] / a[1], sign * w[0] / a[0]));
  double cn, dn;
  const double sn = boost::math::jacobi_elliptic(
      flips.k, first + flips.p * std::fmod(t, 2 * time_of_a_flip(body)), &cn, &dn);
  return {sign * a[0] * cn, a[1] * sn, sign * a[2] * dn};
}

void set_in_plane(MechanismState<double>& state, int body, double x, double y, double angle, double x_dot,
                  double y_dot, double rate) {
  state.pose[body] = {{x, y, 0}, {std::cos(angle / 2), 0, 0, std::sin(angle / 2)}};
  state.twist[body] = {{x_dot, y_dot, 0}, {0, 0, rate}};
}

void set_ladder(MechanismState<double>& state, int n, double angle, double rate) {
  const double c = std::cos(angle), s = std::sin(angle), turn = angle - std::numbers::pi / 2;
  for (int k = 0; k <= n; ++k)
    set_in_plane(state, k, k + c / 2, s / 2, turn, -rate * s / 2, rate * c / 2, rate);
  for (int k = 1; k <= n; ++k) set_in_plane(state, n + k, k - 0.5 + c, s, 0, -rate * s, rate * c, 0);
}

MechanismState<double> state_of_size(std::size_t bodies) {
  MechanismState<double> state;
  state.pose.resize(bodies);
  state.twist.resize(bodies);
  return state;
}

namespace {

/// A crank of length 1 m on the ground and a rod, both of 1 kg, whose end slides along the x axis. `moment`:
/// of inertia of the rod about z [kg m^2].
Scene crank_and_rod(const std::string& name, double rod_length, double moment,
                    const MechanismState<double>& start) {
  const Vector3 z{0, 0, 1}, back{-rod_length / 2, 0, 0}, front{rod_length / 2, 0, 0};
  Scene scene;
  scene.name = name;
  scene.bodies = {body("crank", 1, {0.02, 0.1, 0.1}), body("rod", 1, {0.02, moment, moment})};
  set_state(scene, start);
  scene.constraints = {
      joint(JointType::revolute, "A", side(scenes::ground, Vector3{}, z), side(0, Vector3{-0.5, 0, 0}, z)),
      joint(JointType::revolute, "B", side(0, Vector3{0.5, 0, 0}, z), side(1, back, z)),
      joint(basic_type<CD>, "slide", side(scenes::ground, Vector3{}), side(1, front))};
  scene.constraints.back().direction = {0, 1, 0};
  return scene;
}

/// The sum of m v^2 and J omega^2 of crank and rod, both of 1 kg, per square of the crank's speed.
double inertia_at(double theta) {
  const double s2 = std::sin(theta) * std::sin(theta);
  return (0.1 + 0.25) + (0.1 + 2.25 * s2 + 0.25 * (1 - s2));
}

}  // namespace

Scene rod_on_crank(double rate) {
  MechanismState<double> start = state_of_size(2);
  set_rod_on_crank(start, rate);
  return crank_and_rod(fmt::format("rod_on_crank_{:g}", rate), 1, 0.1, start);
}

// The kinetic energy does not change. By Runge-Kutta steps of order 4, far shorter than needed.
void set_rod_on_crank(MechanismState<double>& state, double rate) {
  double theta = 0.3;
  const double momentum = std::sqrt(inertia_at(theta)) * rate;
  const auto speed = [&](double angle) { return momentum / std::sqrt(inertia_at(angle)); };
  const int steps = 1 + static_cast<int>(4000 * state.t * std::max(1.0, rate));
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

namespace {

constexpr double rod_length = 2, moment_of_rod = 0.4;  // [m, kg m^2]
constexpr double first_angle = 0.3, first_rate = 2;    // [rad, rad/s]

/// The sine and cosine of the rod's angle, and its rate per rate of the crank.
struct RodOfCrank {
  double s, c, rate;
  explicit RodOfCrank(double theta)
      : s(-std::sin(theta) / rod_length),
        c(std::sqrt(1 - s * s)),
        rate(-std::cos(theta) / (rod_length * c)) {}
};

void set_slider_crank(MechanismState<double>& state, double theta, double omega) {
  const double c = std::cos(theta), s = std::sin(theta);
  const RodOfCrank rod(theta);
  set_in_plane(state, 0, c / 2, s / 2, theta, -omega * s / 2, omega * c / 2, omega);
  set_in_plane(state, 1, c + rod_length / 2 * rod.c, s / 2, std::asin(rod.s),
               -omega * (s + rod_length / 2 * rod.s * rod.rate), omega * c / 2, omega * rod.rate);
}

/// The sum of m v^2 and J omega^2 of both bodies per square of the crank's speed.
double inertia_of_slider_crank(double theta) {
  MechanismState<double> state = state_of_size(2);
  set_slider_crank(state, theta, 1);
  return state.twist[0].r_dot.squaredNorm() + state.twist[1].r_dot.squaredNorm() + 0.1 +
         moment_of_rod * std::pow(RodOfCrank(theta).rate, 2);
}

}  // namespace

Scene slider_crank() {
  MechanismState<double> start = state_of_size(2);
  set_slider_crank(start, first_angle, first_rate);
  return crank_and_rod("slider_crank", rod_length, moment_of_rod, start);
}

// The kinetic energy does not change. The trapezoidal rule over a period has an error like exp(-n).
double period_of_slider_crank() {
  constexpr int n = 200;
  double sum = 0;
  for (int k = 0; k < n; ++k) sum += std::sqrt(inertia_of_slider_crank(2 * std::numbers::pi * k / n));
  return 2 * std::numbers::pi * sum / n / (std::sqrt(inertia_of_slider_crank(first_angle)) * first_rate);
}

Scene stone_on_spring(double stiffness, double damping, double free_length, double velocity) {
  Scene scene;
  scene.name = fmt::format("stone_{:g}", stiffness);
  scene.bodies = {body("stone", 1, {0.1, 0.1, 0.1}, {1, 0, 0})};
  scene.bodies[0].velocity = {0, velocity, 0};
  SpringDamper<double> spring;
  spring.name = "spring";
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
