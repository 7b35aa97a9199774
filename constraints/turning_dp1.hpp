#pragma once
/// TurningDP1, the row of a rotation driver: a DP1 with f = 0 whose first vector rotates relative to body i,
/// w_i(t) = -sin(alpha(t)) u_i + cos(alpha(t)) v_i. For unit vectors in one plane, Phi = sin(theta - alpha)
/// with theta the angle from u_i to a_j.

#include "constraints/basic_constraint_parts.hpp"

namespace trivium {

/// Phi = w_i(t) . a_j [-], w_i = -sin(alpha) u_i + cos(alpha) v_i.
template <class Scalar>
struct TurningDP1 : BodyPair {
  static constexpr bool is_of_angle = true;

  Vector3<Scalar> u_bar_i, v_bar_i, a_bar_j;  ///< vectors of i, i and j [-, body frames]
  TimeFunction alpha;                         ///< prescribed angle [rad]

  static void keys(auto&& show, auto&... c) {
    show.vector_i(c.u_bar_i...);
    show.vector_i(c.v_bar_i...);
    show.vector_j(c.a_bar_j...);
    show.need("alpha", c.alpha...);
  }
  const TimeFunction& function() const { return alpha; }
  /// |u_i| |a_j|: the largest change of Phi per radian if |u_i| = |v_i| and u_i, v_i are perpendicular.
  Scalar scale(const Scalar&) const { return u_bar_i.norm() * a_bar_j.norm(); }
  template <BodyKinematics Body, class Use>
  auto with_features(const Body& on_i, const Body& on_j, const Scalar& t, const Use& use) const {
    const auto [sine, cosine] = SineCosine<Scalar>(alpha.phase(t));
    const MovingVectorFeature<Body, End::i> w(on_i, -sine.f * u_bar_i + cosine.f * v_bar_i,
                                              -sine.f_t * u_bar_i + cosine.f_t * v_bar_i,
                                              -sine.f_tt * u_bar_i + cosine.f_tt * v_bar_i);
    return use(w, BodyVectorFeature<Body, End::j>(on_j, a_bar_j), Jet<Scalar>{});
  }
};

}  // namespace trivium
