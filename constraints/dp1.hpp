#pragma once
/// DP1, Phi = a_i . a_j - f(t): prescribes the angle between a vector of body i and a vector of body j, both
/// fixed in their body. f = 0 keeps them perpendicular. Haug (1989), section 9.4.

#include "constraints/basic_constraint_parts.hpp"

namespace trivium {

/// Phi = a_i . a_j - f(t) [-].
template <class Scalar>
struct DP1 : BodyPair {
  static constexpr const char* type = "dp1";
  static constexpr bool is_of_angle = true, sees_relative_motion = true;

  Vector3<Scalar> a_bar_i, a_bar_j;  ///< vectors of i and j [-, body frames]
  TimeFunction f;                    ///< |a_i| |a_j| cos(angle) [-]

  static void keys(auto&& show, auto&... c) {
    show.vector_i(c.a_bar_i...);
    show.vector_j(c.a_bar_j...);
    show.may("f", c.f...);
  }
  const TimeFunction& function() const { return f; }
  /// |a_i| |a_j|: the largest change of Phi per radian.
  Scalar scale(const Scalar&) const { return a_bar_i.norm() * a_bar_j.norm(); }
  /// Whether a_i and a_j are nearly parallel: gradient norm |a_i x a_j| < share |a_i| |a_j|.
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
