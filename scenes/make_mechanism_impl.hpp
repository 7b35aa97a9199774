#pragma once
/// How a scene becomes a mechanism and a state in Scalar. This file decides which numbers are checked against
/// the range of Scalar and how directions are scaled before Scalar normalises them. Slightly negative
/// principal moments of inertia, which the reader accepts within its tolerance, are raised to zero here.
/// Included only by instances/.

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "base/raise.hpp"
#include "base/variants.hpp"
#include "bodies/numbers/scalar.hpp"
#include "bodies/rotations/so3.hpp"
#include "constraints/joint.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/range_checked_cast.hpp"

namespace trivium {

namespace detail {

/// A direction, already scaled by of_moderate_size. A vector whose magnitude matters is cast by
/// RangeCheckedCast.
template <class Scalar>
Vector3<Scalar> direction_of(const scenes::Vector3& v) {
  return {Scalar(v[0]), Scalar(v[1]), Scalar(v[2])};
}

/// The same direction with its largest component between 1 and 2 in magnitude. A scene may state components
/// up to 1e100, whose squares overflow in float when the direction is normalised. Scaling by a power of two
/// is exact.
template <std::size_t n>
std::array<double, n> of_moderate_size(std::array<double, n> direction) {
  double largest = 0;
  for (double x : direction) raise(largest, std::abs(x));
  for (double& x : direction) x = std::ldexp(x, -std::ilogb(largest));
  return direction;
}

/// A matrix [3x3] from its rows. Throws a ModelError as RangeCheckedCast does.
template <class Scalar>
Matrix3<Scalar> matrix_of(const scenes::Matrix3& rows, const RangeCheckedCast<Scalar>& narrowed,
                          std::string_view key) {
  Matrix3<Scalar> m;
  for (int k = 0; k < 3; ++k) m.row(k) = narrowed.vector(rows[k], key).transpose();
  return m;
}

/// The matrix [3x3, kg m^2] that raises the negative principal moments of J to zero when added to J. The
/// reader accepts moments slightly below zero within its tolerance, but no body has them. Moments above -8 u
/// max|J| are rounding of the eigenvalue solver, and stay as they are: J is singular as written. The factor 8
/// is chosen by experiment.
inline Matrix3<double> lift_of_negative_moments(const Matrix3<double>& J) {
  const Eigen::SelfAdjointEigenSolver<Matrix3<double>> principal(J);
  const double rounding = 8 * unit_roundoff<double>() * J.cwiseAbs().maxCoeff();
  const Vector3<double> lift =
      principal.eigenvalues().unaryExpr([&](double moment) { return moment < -rounding ? -moment : 0.0; });
  return principal.eigenvectors() * lift.asDiagonal() * principal.eigenvectors().transpose();
}

/// J_bar of a body [3x3, kg m^2]: symmetric, without negative principal moments. Throws as matrix_of does.
template <class Scalar>
Matrix3<Scalar> inertia_of(const scenes::Body& body, const RangeCheckedCast<Scalar>& narrowed) {
  // A positive moment that would underflow to zero in Scalar is refused: the mass matrix would become
  // singular.
  const auto moment = [&](double written) { return narrowed.number(std::max(written, 0.0), "inertia"); };
  if (const auto* diagonal = std::get_if<scenes::Vector3>(&body.inertia)) {
    const auto& [Jx, Jy, Jz] = *diagonal;
    return Vector3<Scalar>(moment(Jx), moment(Jy), moment(Jz)).asDiagonal();
  }
  const scenes::Matrix3& rows = std::get<scenes::Matrix3>(body.inertia);
  for (std::size_t k = 0; k < 3; ++k) moment(rows[k][k]);
  const Matrix3<Scalar> J = matrix_of<Scalar>(rows, narrowed, "inertia");
  const Matrix3<Scalar> symmetric = (J + J.transpose()) / Scalar(2);
  return symmetric + scalar_cast<Scalar>(lift_of_negative_moments(scalar_cast<double>(symmetric)));
}

/// The joint frame of a side; a point alone if the side has no axis. `point_key` is for messages.
template <class Scalar>
JointFrame<Scalar> frame_of(const scenes::Side& side, const RangeCheckedCast<Scalar>& narrowed,
                            std::string_view point_key) {
  const Vector3<Scalar> point = narrowed.place(side.point.value_or(scenes::Vector3{}), point_key);
  if (!side.axis) return {.point = point};
  const scenes::Vector3 axis = of_moderate_size(*side.axis);
  // default_x selects a coordinate axis e_k by comparing components of the axis. The comparison is made in
  // double: a Scalar that rounds two components to the same value would otherwise select another e_k, and so
  // other rows.
  const Vector3<Scalar> x = side.x ? direction_of<Scalar>(of_moderate_size(*side.x))
                                   : scalar_cast<Scalar>(default_x(direction_of<double>(axis)));
  return joint_frame<Scalar>(point, direction_of<Scalar>(axis), x);
}

/// Key visitor that fills a basic constraint with the values of the scene's constraint.
template <class Scalar>
struct StatedParts {
  const scenes::Constraint& stated;
  const Joint<Scalar>& joint;
  const RangeCheckedCast<Scalar>& narrowed;

  void vector_i(Vector3<Scalar>& a_bar) const { a_bar = narrowed.vector(stated.i.vector, "i/vector"); }
  void vector_j(Vector3<Scalar>& a_bar) const { a_bar = narrowed.vector(stated.j.vector, "j/vector"); }
  void point_i(Vector3<Scalar>& s_bar) const { s_bar = joint.frame_i.point; }
  void point_j(Vector3<Scalar>& s_bar) const { s_bar = joint.frame_j.point; }
  void need(std::string_view key, auto& value) const { take(key, value); }
  void may(std::string_view key, auto& value) const { take(key, value); }

 private:
  void take(std::string_view key, TimeFunction& f) const { f = narrowed.function(stated.f, key); }
  void take(std::string_view key, Vector3<Scalar>& c) const { c = narrowed.vector(stated.direction, key); }
};

/// The row of a basic constraint, between the bodies of `joint`.
template <class Scalar>
BasicConstraint<Scalar> basic_row_of(const scenes::Constraint& stated, const Joint<Scalar>& joint,
                                     const RangeCheckedCast<Scalar>& narrowed) {
  auto row = emplaced<BasicConstraint<Scalar>>(stated.type.place);
  const auto fill = [&](auto& one) {
    static_cast<BodyPair&>(one) = joint;
    one.keys(StatedParts<Scalar>{stated, joint, narrowed}, one);
  };
  std::visit(fill, row);
  return row;
}

/// The rows of a basic constraint or of a joint.
template <class Scalar>
JointRows<Scalar> stated_rows(const scenes::Constraint& stated, const Joint<Scalar>& joint,
                              const RangeCheckedCast<Scalar>& narrowed) {
  if (stated.type.is_basic()) return {{"", basic_row_of(stated, joint, narrowed)}};
  if (properties_of(stated.type).states_a_distance) {
    narrowed.number(stated.distance, "distance");
    narrowed.number(stated.distance * stated.distance, "squared distance");  // right side of the row d
  }
  return rows_of(stated.type.joint, joint, joint.frame_i, joint.frame_j, stated.distance,
                 narrowed.function(stated.angle, "angle"));
}

/// Key visitor that casts the values of a scene's effect (double) to an effect of the mechanism (Scalar).
template <class Scalar>
struct EffectCast {
  const Mechanism<Scalar>& mechanism;
  RangeCheckedCast<Scalar> narrowed;

  void body(std::string_view, const int& from, int& to) const {
    to = from == scenes::ground ? mechanism.ground() : from;
  }
  void point(std::string_view key, const BodyPoint<double>& from, BodyPoint<Scalar>& to) const {
    body(key, from.body, to.body);
    place(fmt::format("{}/point", key), from.s_bar, to.s_bar);
  }
  void joint(std::string_view, const JointAngle<double>& from, JointAngle<Scalar>& to) const {
    const Joint<Scalar>& of = mechanism.joints[from.joint];
    to = {from.joint,   of.i,         of.j,         of.frame_i.u,
          of.frame_i.v, of.frame_i.z, of.frame_j.u, Scalar(from.tracked)};
  }
  void need(std::string_view key, const auto& from, auto& to) const { cast(key, from, to); }
  void may(std::string_view key, const auto& from, auto& to) const { cast(key, from, to); }
  void place(std::string_view key, const Vector3<double>& from, Vector3<Scalar>& to) const {
    to = narrowed.place(from, key);
  }
  void angle(std::string_view key, const double& from, Scalar& to) const { to = narrowed.angle(from, key); }
  void turns(std::string_view, const auto&, auto&) const {}  // cast by joint(), with the tracked angle

 private:
  void cast(std::string_view key, const double& from, Scalar& to) const { to = narrowed.number(from, key); }
  void cast(std::string_view key, const Vector3<double>& from, Vector3<Scalar>& to) const {
    to = narrowed.vector(from, key);
  }
  void cast(std::string_view key, const TimeFunction& from, TimeFunction& to) const {
    to = narrowed.function(from, key);
  }
  void cast(std::string_view key, const std::array<TimeFunction, 3>& from,
            std::array<TimeFunction, 3>& to) const {
    to = narrowed.functions(from, key);
  }
  void cast(std::string_view, ComponentFrame from, ComponentFrame& to) const { to = from; }
};

/// Adds an effect of the scene to a mechanism whose joints are complete.
template <class Scalar, template <class> class E>
void add_effect(const E<double>& from, std::string name, Mechanism<Scalar>& mechanism) {
  E<Scalar> to;
  to.name = std::move(name);
  E<double>::keys(EffectCast<Scalar>{mechanism, {"effect", to.name}}, from, to);
  mechanism.effects.add(std::move(to));
}

/// Converts any form of an orientation to Euler parameters p, |p| = 1.
template <class Scalar>
struct ToEulerParameters {
  RangeCheckedCast<Scalar> narrowed;

  Vector4<Scalar> operator()(const scenes::EulerParameters& o) const {
    const auto e = of_moderate_size(o.e);
    const Vector4<Scalar> p{Scalar(e[0]), Scalar(e[1]), Scalar(e[2]), Scalar(e[3])};
    return p / p.stableNorm();
  }
  Vector4<Scalar> operator()(const scenes::EulerAngles& o) const {
    Vector4<Scalar> p = Vector4<Scalar>::Unit(0);
    for (int k = 0; k < 3; ++k)
      p = multiply_parameters<Scalar>(
          p, turn(Vector3<Scalar>::Unit(o.sequence.axis[k]), narrowed.angle(o.angles[k], "euler_angles")));
    return p / p.norm();
  }
  Vector4<Scalar> operator()(const scenes::AxisAngle& o) const {
    const Vector3<Scalar> axis = direction_of<Scalar>(of_moderate_size(o.axis));
    return turn(axis / axis.stableNorm(), narrowed.angle(o.angle, "angle"));
  }
  Vector4<Scalar> operator()(const scenes::RotationMatrix& o) const {
    return euler_parameters(matrix_of<Scalar>(o.A, narrowed, "matrix"));
  }

  static Vector4<Scalar> turn(const Vector3<Scalar>& axis, const Scalar& angle) {
    using std::cos, std::sin;
    const Scalar half = angle / 2;
    Vector4<Scalar> p;
    p << Scalar(cos(half)), Scalar(sin(half)) * axis;
    return p / p.norm();
  }
};

}  // namespace detail

template <class Scalar>
Vector4<Scalar> euler_parameters_of(const scenes::Orientation& orientation) {
  return std::visit(detail::ToEulerParameters<Scalar>{{"body", ""}}, orientation);
}

template <class Scalar>
Mechanism<Scalar> make_mechanism(const scenes::Scene& scene) {
  Mechanism<Scalar> m;
  m.name = scene.name;
  m.rank_tolerance = scene.rank_tolerance;
  for (const scenes::Body& body : scene.bodies) {
    m.body_names.push_back(body.name);
    const RangeCheckedCast<Scalar> narrowed("body", body.name);
    m.bodies.push_back({narrowed.number(body.mass, "mass"), detail::inertia_of<Scalar>(body, narrowed)});
  }
  m.body_names.push_back("ground");
  for (const scenes::Constraint& c : scene.constraints) {
    const RangeCheckedCast<Scalar> narrowed("constraint", c.name);
    Joint<Scalar> joint;
    joint.i = c.i.body == scenes::ground ? m.ground() : c.i.body;
    joint.j = c.j.body == scenes::ground ? m.ground() : c.j.body;
    joint.name = c.name;
    joint.type = c.type;
    joint.frame_i = detail::frame_of<Scalar>(c.i, narrowed, "i/point");
    joint.frame_j = detail::frame_of<Scalar>(c.j, narrowed, "j/point");
    joint.angle = c.angle;
    joint.first_row = m.nc();
    for (NamedRow<Scalar>& row : detail::stated_rows(c, joint, narrowed)) {
      m.row_names.push_back(row.label.empty() ? c.name : c.name + "." + row.label);
      m.rows.push_back(std::move(row.constraint));
    }
    joint.rows = m.nc() - joint.first_row;
    m.joints.push_back(std::move(joint));
  }
  for (std::size_t k = 0; k < scene.effects.size(); ++k) {
    const auto add = [&](const auto& effect) {
      detail::add_effect(effect, effect.name.empty() ? fmt::format("/effects/{}", k) : effect.name, m);
    };
    std::visit(add, scene.effects[k]);
  }
  return m;
}

template <class Scalar>
MechanismState<Scalar> make_state(const scenes::Scene& scene, Scalar t) {
  MechanismState<Scalar> state;
  state.t = RangeCheckedCast<Scalar>::time(t);
  for (const scenes::Body& body : scene.bodies) {
    const RangeCheckedCast<Scalar> narrowed("body", body.name);
    state.pose.push_back({narrowed.place(body.position, "position"),
                          std::visit(detail::ToEulerParameters<Scalar>{narrowed}, body.orientation)});
    state.twist.push_back({narrowed.place(body.velocity, "velocity"),
                           narrowed.place(body.angular_velocity, "angular_velocity")});
  }
  return state;
}

}  // namespace trivium
