#pragma once
/// A mechanism's numbers in another Scalar, such as the same number in every lane of a batch.

#include <variant>

#include "mechanism/mechanism.hpp"

namespace trivium {

namespace detail {

template <class To>
struct Cast {
  template <class From, int R, int C>
  static Matrix<To, R, C> matrix(const Matrix<From, R, C>& m) {
    return m.unaryExpr([](const From& x) { return To(x); }).eval();
  }
  template <class From>
  static JointFrame<To> frame(const JointFrame<From>& f) {
    return {matrix(f.point), matrix(f.u), matrix(f.v), matrix(f.z)};
  }

  // constraint rows
  template <class From>
  static BasicConstraint<To> row(const DP1<From>& c) {
    return DP1<To>{c, matrix(c.a_bar_i), matrix(c.a_bar_j), c.f};
  }
  template <class From>
  static BasicConstraint<To> row(const TurningDP1<From>& c) {
    return TurningDP1<To>{c, matrix(c.u_bar_i), matrix(c.v_bar_i), matrix(c.a_bar_j), c.alpha};
  }
  template <class From>
  static BasicConstraint<To> row(const DP2<From>& c) {
    return DP2<To>{c, matrix(c.a_bar_i), matrix(c.s_bar_i), matrix(c.s_bar_j), c.f};
  }
  template <class From>
  static BasicConstraint<To> row(const D<From>& c) {
    return D<To>{c, matrix(c.s_bar_i), matrix(c.s_bar_j), c.f};
  }
  template <class From>
  static BasicConstraint<To> row(const CD<From>& c) {
    return CD<To>{c, matrix(c.c), matrix(c.s_bar_i), matrix(c.s_bar_j), c.f};
  }

  // effects
  template <class From>
  static auto effect(const Gravity<From>& e) {
    return Gravity<To>{matrix(e.g)};
  }
  template <class From>
  static auto effect(const Force<From>& e) {
    return Force<To>{e.body, matrix(e.s_bar), e.components, e.frame};
  }
  template <class From>
  static auto effect(const Torque<From>& e) {
    return Torque<To>{e.body, e.components, e.frame};
  }
  template <class From>
  static auto effect(const SpringDamper<From>& e) {
    return SpringDamper<To>{e.name,
                            e.i,
                            e.j,
                            matrix(e.s_bar_i),
                            matrix(e.s_bar_j),
                            To(e.stiffness),
                            To(e.damping),
                            To(e.free_length),
                            e.actuator};
  }
  template <class From>
  static auto effect(const TorsionalSpringDamper<From>& e) {
    return TorsionalSpringDamper<To>{e.i,
                                     e.j,
                                     matrix(e.u_bar_i),
                                     matrix(e.v_bar_i),
                                     matrix(e.z_bar_i),
                                     matrix(e.u_bar_j),
                                     To(e.stiffness),
                                     To(e.damping),
                                     To(e.free_angle),
                                     e.actuator,
                                     To(e.followed)};
  }
};

}  // namespace detail

template <class To, class From>
Mechanism<To> mechanism_cast(const Mechanism<From>& from) {
  using Cast = detail::Cast<To>;
  Mechanism<To> to;
  to.name = from.name;
  to.body_names = from.body_names;
  to.row_names = from.row_names;
  for (const RigidBody<From>& body : from.bodies)
    to.bodies.push_back({To(body.mass), Cast::matrix(body.inertia)});
  for (const BasicConstraint<From>& row : from.rows)
    to.rows.push_back(std::visit([](const auto& c) { return Cast::row(c); }, row));
  for (const Joint<From>& joint : from.joints)
    to.joints.push_back({joint, joint.name, joint.type, Cast::frame(joint.frame_i),
                         Cast::frame(joint.frame_j), joint.first_row, joint.rows, joint.angle});
  const auto cast_all = [&]<class Effect>(const std::vector<Effect>& effects) {
    for (const Effect& effect : effects) to.effects.add(Cast::effect(effect));
  };
  cast_all(from.effects.template all<Gravity<From>>());
  cast_all(from.effects.template all<Force<From>>());
  cast_all(from.effects.template all<Torque<From>>());
  cast_all(from.effects.template all<SpringDamper<From>>());
  cast_all(from.effects.template all<TorsionalSpringDamper<From>>());
  return to;
}

}  // namespace trivium
