#pragma once
/// CD, Phi = c . d_ij - f(t): prescribes the component of d_ij along a global vector c. d_ij goes from a
/// point of body i to a point of body j. Haug (1989), section 9.4.

#include "constraints/basic_constraint_parts.hpp"

namespace trivium {

/// Phi = c . d_ij - f(t) [m if |c| = 1]; c is a global vector.
template <class Scalar>
struct CD : BodyPair {
  static constexpr const char* type = "cd";
  static constexpr bool is_of_angle = false, sees_relative_motion = false;

  Vector3<Scalar> c, s_bar_i, s_bar_j;  ///< direction [-, global]; points of i and j [m, body frames]
  TimeFunction f;                       ///< prescribed component times |c| [m]

  static void keys(auto&& show, auto&... c) {
    show.need("direction", c.c...);
    show.point_i(c.s_bar_i...);
    show.point_j(c.s_bar_j...);
    show.may("f", c.f...);
  }
  const TimeFunction& function() const { return f; }
  /// |c|: the change of Phi per metre.
  Scalar scale(const Scalar&) const { return c.norm(); }
  template <BodyKinematics Body, class Use>
  auto with_features(const Body& on_i, const Body& on_j, const Scalar& t, const Use& use) const {
    return use(ConstantFeature<Scalar>{c}, PointOffsetFeature<Body>(on_i, s_bar_i, on_j, s_bar_j), f(t));
  }
};

}  // namespace trivium
