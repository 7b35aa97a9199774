#pragma once
/// DP1: a_i . a_j - f(t), an angle between a vector on each body (Haug 1989, section 9.4). f = 0 keeps them
/// perpendicular.

#include "constraints/basic_constraint_parts.hpp"

namespace trivium {

template <class Scalar>
struct DP1 : BodyPair {
  static constexpr const char* type = "dp1";
  static constexpr bool is_of_angle = true, sees_relative_motion = true;

  Vector3<Scalar> a_bar_i, a_bar_j;
  TimeFunction f;

  static void keys(auto&& show, auto&... c) {
    show.vector_i(c.a_bar_i...);
    show.vector_j(c.a_bar_j...);
    show.may("f", c.f...);
  }
  const TimeFunction& function() const { return f; }
  /// |a_i| |a_j|
  Scalar scale(const Scalar&) const { return a_bar_i.norm() * a_bar_j.norm(); }
  /// Nearly parallel vectors: the row does less than `share` of what it could.
  template <class Body>
  bool vanishes(const Body& on_i, const Body& on_j, const Scalar& share) const {
    const Vector3<Scalar> a_i = on_i.A * a_bar_i, a_j = on_j.A * a_bar_j;
    return a_i.cross(a_j).squaredNorm() < share * share * a_i.squaredNorm() * a_j.squaredNorm();
  }
  template <BodyKinematics Body, class Use>
  auto with_features(const Body& on_i, const Body& on_j, const Scalar& t, const Use& use) const {
    return use(BodyVectorFeature<Body, End::i>(on_i, a_bar_i), BodyVectorFeature<Body, End::j>(on_j, a_bar_j),
               f(t));
  }
};

}  // namespace trivium
