#include "scenes/random_scene.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "bodies/rotations/so3.hpp"
#include "scenes/format/scene_keys.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/random_basic_row.hpp"
#include "scenes/random_draw.hpp"

namespace trivium::scenes {

namespace {

using V = RandomDraw::V;
using M = RandomDraw::M;

/// Builds one scene. The probabilities and ranges are chosen by experiment: bodies of about 1 m, moderate
/// speeds, trees and loops in similar numbers, and now and then a free body or a repeated joint.
class Builder {
 public:
  Builder(std::uint64_t seed, const RandomOptions& options) : draw_(seed), options_(options) {
    out_.t = draw_.uniform(-2, 2);
  }

  RandomScene build() {
    const int nb = 1 + draw_.below(options_.most_bodies);
    for (int b = 0; b < nb; ++b) add_body();
    for (int b = 0; b < nb; ++b)
      if (!draw_.chance(0.05)) add_joint(draw_.chance(0.3) ? ground : draw_.below(b + 1) - 1, b);
    const int loops = draw_.chance(0.6) ? 1 + draw_.below(1 + nb / 2) : 0;
    for (int k = 0; k < loops; ++k) close_loop();
    if (options_.effects) add_effects();
    return std::move(out_);
  }

 private:
  void add_body() {
    Body body;
    body.name = fmt::format("body_{}", out_.scene.bodies.size() + 1);
    const double half_decades = std::log10(options_.mass_ratio) / 2;
    body.mass = std::pow(10.0, draw_.uniform(-half_decades, half_decades));
    const V edge = draw_.vector(0.1, 1);
    const V square = edge.cwiseAbs2();
    const M R = draw_.rotation();
    const M J = R *
                (body.mass / 12 * V(square[1] + square[2], square[0] + square[2], square[0] + square[1]))
                    .asDiagonal() *
                R.transpose();
    Matrix3 inertia;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) inertia[r][c] = J(std::max(r, c), std::min(r, c));
    body.inertia = inertia;
    body.position = plain(draw_.vector(2));
    const Vector4<double> p = euler_parameters<double>(draw_.rotation());
    body.orientation = EulerParameters{{p[0], p[1], p[2], p[3]}};
    body.velocity = plain(draw_.vector(3));
    body.angular_velocity = plain(draw_.vector(5));
    out_.scene.bodies.push_back(body);
    A_.push_back(rotation_matrix(p));
    r_.push_back(V(body.position[0], body.position[1], body.position[2]));
  }

  V to_body(int body, const V& global) const {
    return body == ground ? global : V(A_[body].transpose() * global);
  }
  V point_in(int body, const V& global) const {
    return body == ground ? global : V(A_[body].transpose() * (global - r_[body]));
  }
  V place_near(int body) { return (body == ground ? V(V::Zero()) : r_[body]) + draw_.vector(1); }

  Side side(int body, const V& point, const V& axis, const V& x) const {
    Side s;
    s.body = body;
    s.point = plain(point_in(body, point));
    s.axis = plain(to_body(body, axis));
    s.x = plain(to_body(body, x));
    return s;
  }
  Constraint& add(ConstraintType type, const Side& i, const Side& j) {
    Constraint c;
    c.type = type;
    c.name = fmt::format("c{}", out_.scene.constraints.size() + 1);
    c.i = i;
    c.j = j;
    out_.scene.constraints.push_back(c);
    return out_.scene.constraints.back();
  }

  /// A function of time with the given value at out_.t. It varies with time only if `moving`.
  TimeFunction through(double value, bool moving) {
    if (!moving) return value;
    const double w = draw_.uniform(0.5, 3), phase = draw_.uniform(-3, 3),
                 amplitude = draw_.uniform(-0.5, 0.5);
    if (draw_.chance(0.5))
      return TimeFunction::Harmonic{value - amplitude * std::sin(w * out_.t + phase), amplitude, w, phase};
    const double c1 = draw_.uniform(-1, 1), c2 = draw_.uniform(-0.5, 0.5);
    return TimeFunction::Polynomial{{value - c1 * out_.t - c2 * out_.t * out_.t, c1, c2}};
  }

  /// Adds a joint of a random type between two bodies, fitted to their positions.
  void add_joint(int i, int j) {
    if (draw_.chance(0.5)) std::swap(i, j);
    static const std::vector<ConstraintType> types = [] {
      std::vector<ConstraintType> all{JointType::revolute,      JointType::revolute, JointType::spherical,
                                      JointType::universal,     JointType::fixed,    JointType::cylindrical,
                                      JointType::translational, JointType::planar,   JointType::in_line,
                                      JointType::in_plane,      JointType::distance};
      // Append the types that are missing above. A seed draws an index into this list: do not reorder it. A
      // new type changes the scenes of all seeds. Drivers are not listed: they are added together with a
      // revolute.
      for (const ConstraintShape& known : constraint_shapes()) {
        const bool is_fitted = known.type.is_basic() ? known.shape.find("f") != nullptr
                                                     : !properties_of(known.type).drives_an_angle;
        if (is_fitted && std::find(all.begin(), all.end(), known.type) == all.end())
          all.push_back(known.type);
      }
      return all;
    }();
    add_joint_of(types[draw_.below(static_cast<int>(types.size()))], i, j);
  }

  void add_joint_of(ConstraintType type, int i, int j) {
    const V P = place_near(j == ground ? i : j);
    V Q = place_near(j == ground ? i : j);
    while ((Q - P).norm() < far_from_singular) Q = place_near(j == ground ? i : j);
    const M R = draw_.rotation();
    const V x = R.col(0), y = R.col(1), z = R.col(2);
    const double angle = draw_.uniform(-3, 3);
    const V turned_x = std::cos(angle) * x + std::sin(angle) * y;
    const double along = draw_.uniform(-1, 1), across = draw_.uniform(-1, 1);
    const bool moving = draw_.chance(0.3);
    switch (type.joint) {
      case JointType::basic:
        add_basic(type, i, j, random_basic_row(type, draw_, out_.t, P, Q, x, y), moving);
        break;
      case JointType::spherical:
        add_points(type, i, P, j, P);
        break;
      case JointType::universal:
        add(type, side(i, P, z, x), side(j, P, x, y));
        break;
      case JointType::revolute:
        add(type, side(i, P, z, x), side(j, P, z, turned_x));
        if (draw_.chance(0.2)) add_driver(side(i, P, z, x), side(j, P, z, turned_x), angle);
        break;
      case JointType::cylindrical:
        add(type, side(i, P, z, x), side(j, P + along * z, z, turned_x));
        break;
      case JointType::translational:
        add(type, side(i, P, z, x), side(j, P + along * z, z, x));
        break;
      case JointType::fixed:
        add(type, side(i, P, z, x), side(j, P, z, x));
        break;
      case JointType::planar:
        add(type, side(i, P, z, x), side(j, P + along * x + across * y, z, turned_x));
        break;
      case JointType::in_line:
        add_axis_and_point(type, i, P, z, x, j, P + along * z);
        break;
      case JointType::in_plane:
        add_axis_and_point(type, i, P, z, x, j, P + along * x + across * y);
        break;
      case JointType::distance:
        add_points(type, i, P, j, Q).distance = (Q - P).norm();
        break;
      case JointType::rotation_driver:
        break;  // added together with its revolute
    }
  }

  /// Adds a basic constraint that the positions of the bodies satisfy at out_.t.
  void add_basic(ConstraintType type, int i, int j, const RandomBasicRow& drawn, bool moving) {
    const auto side = [&](int body, const Side& global) {
      Side s;
      s.body = body;
      if (global.point) s.point = plain(point_in(body, V(global.point->data())));
      if (global.vector) s.vector = plain(to_body(body, V(global.vector->data())));
      return s;
    };
    Constraint& row = add(type, side(i, drawn.i), side(j, drawn.j));
    row.direction = drawn.direction;
    row.f = through(drawn.f, moving);
  }

  Constraint& add_points(ConstraintType type, int i, const V& P, int j, const V& Q) {
    Side si, sj;
    si.body = i, si.point = plain(point_in(i, P));
    sj.body = j, sj.point = plain(point_in(j, Q));
    return add(type, si, sj);
  }
  void add_axis_and_point(ConstraintType type, int i, const V& P, const V& z, const V& x, int j, const V& Q) {
    Side sj;
    sj.body = j, sj.point = plain(point_in(j, Q));
    add(type, side(i, P, z, x), sj);
  }
  void add_driver(const Side& i, const Side& j, double angle) {
    add(JointType::rotation_driver, i, j).angle = through(angle, true);
  }

  /// Adds one more joint between two bodies, unless the scene would have as many rows as velocities (6 nb).
  void close_loop() {
    const int nb = static_cast<int>(out_.scene.bodies.size());
    const int j = draw_.below(nb);
    int i = draw_.below(nb + 1) - 1;
    if (i == j) i = ground;
    const Scene before = out_.scene;
    if (options_.redundant && draw_.chance(0.15) && !before.constraints.empty())
      repeat(before.constraints[draw_.below(static_cast<int>(before.constraints.size()))]);
    else
      add_joint(i, j);
    if (make_mechanism<double>(out_.scene).nc() >= 6 * nb) out_.scene = before;
  }

  /// Adds a redundant joint: a copy of a revolute or cylindrical joint, moved by 0.5 m along its axis.
  void repeat(const Constraint& original) {
    if (!properties_of(original.type).has_an_angle) return;
    Constraint copy = original;
    copy.name = fmt::format("c{}", out_.scene.constraints.size() + 1);
    const auto shift = [](Side& s, double by) {
      const V axis = V(s.axis->data()).normalized();
      s.point = plain(V(s.point->data()) + by * axis);
    };
    shift(copy.i, 0.5);
    shift(copy.j, 0.5);
    out_.scene.constraints.push_back(copy);
  }

  void add_effects() {
    const int nb = static_cast<int>(out_.scene.bodies.size());
    if (draw_.chance(0.9)) out_.scene.effects.push_back(Gravity<double>{"", 9.81 * draw_.direction()});
    const auto components = [&](double size) {
      const bool moving = draw_.chance(0.5);
      return std::array<TimeFunction, 3>{through(draw_.uniform(-size, size), moving),
                                         draw_.uniform(-size, size), draw_.uniform(-size, size)};
    };
    const auto frame = [&] { return draw_.chance(0.5) ? ComponentFrame::global : ComponentFrame::body; };
    if (draw_.chance(0.4))
      out_.scene.effects.push_back(
          Force<double>{"", draw_.below(nb), draw_.vector(1), components(20), frame()});
    if (draw_.chance(0.4))
      out_.scene.effects.push_back(Torque<double>{"", draw_.below(nb), components(5), frame()});
    if (draw_.chance(0.5)) add_spring();
    for (std::size_t k = 0; k < out_.scene.constraints.size(); ++k) {
      const ConstraintType type = out_.scene.constraints[k].type;
      if (properties_of(type).has_an_angle && draw_.chance(0.3))
        out_.scene.effects.push_back(TorsionalSpringDamper<double>{"",
                                                                   {static_cast<int>(k)},
                                                                   draw_.uniform(0, 50),
                                                                   draw_.uniform(0, 2),
                                                                   draw_.uniform(-1, 1),
                                                                   through(draw_.uniform(-1, 1), true)});
    }
  }
  void add_spring() {
    const int j = draw_.below(static_cast<int>(out_.scene.bodies.size()));
    SpringDamper<double> spring;
    spring.i = {ground, draw_.vector(3) + V(4, 0, 0)};
    spring.j = {j, draw_.vector(0.5)};
    spring.stiffness = draw_.uniform(0, 200);
    spring.damping = draw_.uniform(0, 10);
    spring.free_length = draw_.uniform(0, 2);
    const bool moving = draw_.chance(0.5);
    spring.actuator = through(draw_.uniform(-5, 5), moving);
    out_.scene.effects.push_back(spring);
  }

  RandomDraw draw_;
  RandomOptions options_;
  RandomScene out_;
  std::vector<M> A_;
  std::vector<V> r_;
};

}  // namespace

RandomScene random_scene(std::uint64_t seed, const RandomOptions& options) {
  return Builder(seed, options).build();
}

}  // namespace trivium::scenes
