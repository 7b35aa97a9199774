#pragma once
/// DP2, Phi = a_i . d_ij - f(t): prescribes the component of d_ij along a vector a_i fixed in body i. d_ij
/// goes from a point of body i to a point of body j. Haug (1989), section 9.4.

#include "constraints/basic_constraint_parts.hpp"

namespace trivium {

/// Phi = a_i . d_ij - f(t) [m if |a_i| = 1].
template <class Scalar>
struct DP2 : BodyPair {
  static constexpr const char* type = "dp2";
  static constexpr bool is_of_angle = false, sees_relative_motion = true;

  Vector3<Scalar> a_bar_i, s_bar_i, s_bar_j;  ///< vector [-] and point [m] of i, point of j [m]; body frames
  TimeFunction f;                             ///< prescribed component times |a_i| [m]

  static void keys(auto&& show, auto&... c) {
    show.vector_i(c.a_bar_i...);
    show.point_i(c.s_bar_i...);
    show.point_j(c.s_bar_j...);
    show.may("f", c.f...);
  }
  const TimeFunction& function() const { return f; }
  /// |a_i|: the change of Phi per metre.
  Scalar scale(const Scalar&) const { return a_bar_i.norm(); }
  template <BodyKinematics Body, class Use>
  auto with_features(const Body& on_i, const Body& on_j, const Scalar& t, const Use& use) const {
    return use(BodyVectorFeature<Body, End::i>(on_i, a_bar_i),
               PointOffsetFeature<Body>(on_i, s_bar_i, on_j, s_bar_j), f(t));
  }
};

}  // namespace trivium
