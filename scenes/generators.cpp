#include "scenes/generators.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "bodies/rotations/so3.hpp"
#include "scenes/building.hpp"
#include "scenes/random_draw.hpp"

namespace trivium::scenes {

namespace {

using V = trivium::Vector3<double>;
using P = trivium::Vector4<double>;

/// An empty scene of size n. Throws std::invalid_argument if n is less than `least`.
Scene sized(const char* kind, int n, int least, const std::string& description) {
  if (n < least) throw std::invalid_argument(fmt::format("a scene needs n >= {}, not {}", least, n));
  Scene scene;
  scene.name = fmt::format("{}_{}", kind, n);
  scene.description = description;
  return scene;
}

/// A bar along its own x axis with joints at both ends, and its motion.
struct Bar {
  P p = P::Unit(0);
  V r = V::Zero(), r_dot = V::Zero(), omega = V::Zero();  ///< velocities in the global frame [m/s, rad/s]

  V end(double x) const { return r + rotation_matrix(p) * V(x, 0, 0); }
  V end_velocity(double x) const { return r_dot + omega.cross(end(x) - r); }
};

/// The bar that hangs on the outer end of `inboard`, or on the origin of the ground if there is none. The bar
/// is turned by `angle` [rad] about `axis` (frame of `inboard`, unit vector) and turns at `rate` [rad/s]
/// relative to it.
Bar hang(const Bar* inboard, const V& axis, double angle, double rate) {
  Bar bar;
  const P turn = exponential_parameters<double>(angle * axis);
  const P base = inboard ? inboard->p : P(P::Unit(0));
  bar.p = multiply_parameters<double>(base, turn);
  bar.p /= bar.p.norm();
  bar.omega = (inboard ? inboard->omega : V(V::Zero())) + rotation_matrix(base) * (rate * axis);
  const V hinge = inboard ? inboard->end(0.5) : V(V::Zero());
  const V hinge_velocity = inboard ? inboard->end_velocity(0.5) : V(V::Zero());
  const V arm = rotation_matrix(bar.p) * V(0.5, 0, 0);
  bar.r = hinge + arm;
  bar.r_dot = hinge_velocity + bar.omega.cross(arm);
  return bar;
}

Body body_of(const std::string& name, const Bar& bar) {
  Body body;
  body.name = name;
  body.mass = 1;
  // of a homogeneous bar, 1 kg, 1 m x 0.1 m x 0.1 m
  body.inertia = Vector3{1.0 / 600, 1.01 / 12, 1.01 / 12};
  body.position = plain(bar.r);
  body.orientation = EulerParameters{{bar.p[0], bar.p[1], bar.p[2], bar.p[3]}};
  body.velocity = plain(bar.r_dot);
  body.angular_velocity = plain(rotation_matrix(bar.p).transpose() * bar.omega);
  return body;
}

/// The revolute between the outer end of body i (the origin, if i is the ground) and the inner end of body j.
/// The axis has the same components in both body frames.
Constraint hinge(const std::string& name, int i, int j, const V& axis) {
  Constraint c;
  c.type = JointType::revolute;
  c.name = name;
  c.i.body = i;
  c.i.point = i == ground ? Vector3{0, 0, 0} : Vector3{0.5, 0, 0};
  c.j.body = j;
  c.j.point = Vector3{-0.5, 0, 0};
  c.i.axis = c.j.axis = plain(axis);
  return c;
}

Constraint revolute_about_z(const std::string& name, int i, const Vector3& point_i, int j,
                            const Vector3& point_j) {
  return building::joint(JointType::revolute, name, {i, point_i, {}, Vector3{0, 0, 1}, {}},
                         {j, point_j, {}, Vector3{0, 0, 1}, {}});
}

Body rod(const std::string& name, const Vector3& inertia, const Vector3& position, const Vector3& velocity,
         double turn) {
  Body body;
  body.name = name;
  body.mass = 1;
  body.inertia = inertia;
  body.position = position;
  body.velocity = velocity;
  body.angular_velocity = {0, 0, turn};
  return body;
}

}  // namespace

// Angles and rates are sines and cosines of multiples of k, so that no two joints of a scene are alike. The
// amplitudes are chosen by experiment, far from singular positions.
Scene chain(int n) {
  Scene scene = sized("chain", n, 1, fmt::format("{} bars in series on revolutes with alternating axes", n));
  Bar last;
  for (int k = 0; k < n; ++k) {
    const V axis = V::Unit(k % 2 == 0 ? 1 : 2);
    last = hang(k == 0 ? nullptr : &last, axis, 0.3 * std::sin(1.3 * k + 0.7), 0.2 * std::cos(0.9 * k));
    scene.bodies.push_back(body_of(fmt::format("bar_{}", k + 1), last));
    scene.constraints.push_back(hinge(fmt::format("J{}", k + 1), k == 0 ? ground : k - 1, k, axis));
  }
  scene.effects.push_back(Gravity<double>{"", {0, 0, -9.81}});
  return scene;
}

Scene two_bars() {
  Scene scene;
  scene.name = "two_bars";
  scene.description = "a double pendulum in space: two bars on revolutes along y and z";
  const V y = V::Unit(1), z = V::Unit(2);
  const Bar upper = hang(nullptr, y, 0.3, 0.1), lower = hang(&upper, z, 0.5, -0.2);
  scene.bodies = {body_of("upper", upper), body_of("lower", lower)};
  scene.constraints = {hinge("J1", ground, 0, y), hinge("J2", 0, 1, z)};
  scene.effects.push_back(Gravity<double>{"", {0, 0, -9.81}});
  return scene;
}

Scene ladder(int n) {
  Scene scene = sized("ladder", n, 1, fmt::format("IFToMM A02 with {} loops", n));
  const double J = 1.0 / 12;
  for (int k = 0; k <= n; ++k)
    scene.bodies.push_back(rod(fmt::format("rod_{}", k), {J, 0, J}, {1.0 * k, 0.5, 0}, {0.5, 0, 0}, -1));
  for (int k = 1; k <= n; ++k)
    scene.bodies.push_back(rod(fmt::format("coupler_{}", k), {0, J, J}, {k - 0.5, 1, 0}, {1, 0, 0}, 0));
  const auto pivot = [&](int k) {
    scene.constraints.push_back(
        revolute_about_z(fmt::format("A{}", k), ground, {1.0 * k, 0, 0}, k, {0, -0.5, 0}));
  };
  pivot(0);
  for (int k = 1; k <= n; ++k) {
    const int coupler = n + k;
    scene.constraints.push_back(
        revolute_about_z(fmt::format("B{}", k - 1), k - 1, {0, 0.5, 0}, coupler, {-0.5, 0, 0}));
    pivot(k);
    scene.constraints.push_back(
        revolute_about_z(fmt::format("B{}_left", k), coupler, {0.5, 0, 0}, k, {0, 0.5, 0}));
  }
  scene.effects.push_back(Gravity<double>{"", {0, -9.81, 0}});
  return scene;
}

Scene tree(int n, std::uint64_t seed) {
  Scene scene = sized("tree", n, 1,
                      fmt::format("{} bars, each hung on a randomly drawn earlier bar, seed {}", n, seed));
  RandomDraw random(seed);
  std::vector<Bar> bars;
  bars.reserve(static_cast<std::size_t>(n));
  for (int k = 0; k < n; ++k) {
    const int inboard = k == 0 ? ground : random.below(k);
    // one draw a statement: the order of draws within a call depends on the compiler
    const double z = random.uniform(0.2, 1);
    const double y = random.uniform(-1, 1);
    const double x = random.uniform(-1, 1);
    const V axis = V(x, y, z).normalized();
    const double rate = random.uniform(-1, 1);
    const double angle = random.uniform(-1.5, 1.5);
    bars.push_back(hang(inboard == ground ? nullptr : &bars[inboard], axis, angle, rate));
    scene.bodies.push_back(body_of(fmt::format("bar_{}", k + 1), bars.back()));
    scene.constraints.push_back(hinge(fmt::format("J{}", k + 1), inboard, k, axis));
  }
  scene.effects.push_back(Gravity<double>{"", {0, 0, -9.81}});
  return scene;
}

Scene ring(int n) {
  Scene scene = sized("ring", n, 3,
                      fmt::format("a regular polygon of {} bars on spherical joints, one of them held", n));
  const double corner = 2 * std::numbers::pi / n, apothem = 0.5 / std::tan(corner / 2), turn = 0.8;
  // Velocity [m/s] of corner k perpendicular to the plane of the polygon. Corners may have any such
  // velocities: to first order they do not change the length of a bar. The first bar (corners 0 and 1) stays
  // in the plane.
  const auto lift = [n](int k) { return k % n < 2 ? 0.0 : 0.5 * std::sin(1.7 * (k % n)); };
  for (int k = 0; k < n; ++k) {
    Bar bar;
    bar.p = exponential_parameters<double>(V(0, corner * k, 0));
    const auto A = rotation_matrix(bar.p);
    bar.r = A * V(0, 0, apothem) - V(0, 0, apothem);
    const double spin = k == 0 ? 0.0 : std::cos(0.9 * k);
    bar.omega = A * V(spin, turn, lift(k + 1) - lift(k));
    bar.r_dot = V(0, turn, 0).cross(bar.r) + V(0, (lift(k) + lift(k + 1)) / 2, 0);
    scene.bodies.push_back(body_of(fmt::format("bar_{}", k + 1), bar));
  }
  scene.constraints.push_back(building::joint(JointType::revolute, "hold",
                                              {ground, Vector3{0, 0, 0}, {}, Vector3{0, 1, 0}, {}},
                                              {0, Vector3{0, 0, 0}, {}, Vector3{0, 1, 0}, {}}));
  for (int k = 0; k < n; ++k)
    scene.constraints.push_back(building::joint(JointType::spherical, fmt::format("J{}", k + 1),
                                                {k, Vector3{0.5, 0, 0}, {}, {}, {}},
                                                {(k + 1) % n, Vector3{-0.5, 0, 0}, {}, {}, {}}));
  scene.effects.push_back(Gravity<double>{"", {0, 0, -9.81}});
  return scene;
}

Scene hub(int n) {
  Scene scene = sized("hub", n, 1, fmt::format("a wheel on an upright axle, {} bars hung on its rim", n));
  // the radius [m] is the length of a bar, so that the outer end of a spoke lies on the rim
  const double radius = 1, turn = 0.7;
  Body wheel = rod("wheel", {2.5, 2.5, 5}, {0, 0, 0}, {0, 0, 0}, turn);
  wheel.mass = 10;
  scene.bodies.push_back(wheel);
  scene.constraints.push_back(revolute_about_z("axle", ground, {0, 0, 0}, 0, {0, 0, 0}));
  for (int k = 1; k <= n; ++k) {
    // An imaginary bar from the axle to the rim, on whose outer end hang() puts the real bar.
    Bar spoke;
    spoke.p = exponential_parameters<double>(V(0, 0, 2 * std::numbers::pi * k / n));
    spoke.r = rotation_matrix(spoke.p) * V(radius / 2, 0, 0);
    spoke.omega = V(0, 0, turn);
    spoke.r_dot = spoke.omega.cross(spoke.r);
    const V rim = spoke.end(radius / 2), axis = rotation_matrix(spoke.p) * V(0, 1, 0);
    const Bar bar = hang(&spoke, V(0, 1, 0), 0.4 + 0.3 * std::sin(1.3 * k), std::cos(0.9 * k));
    scene.bodies.push_back(body_of(fmt::format("bar_{}", k), bar));
    scene.constraints.push_back(building::joint(JointType::revolute, fmt::format("J{}", k),
                                                {0, plain(rim), {}, plain(axis), {}},
                                                {k, Vector3{-0.5, 0, 0}, {}, Vector3{0, 1, 0}, {}}));
  }
  scene.effects.push_back(Gravity<double>{"", {0, 0, -9.81}});
  return scene;
}

}  // namespace trivium::scenes
