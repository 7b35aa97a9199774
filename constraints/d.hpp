#pragma once
/// D, Phi = d_ij . d_ij - f(t): prescribes the squared distance between a point of body i and a point of body
/// j. f must be positive, since the row has no gradient at distance 0. Haug (1989), section 9.4.

#include <cmath>

#include "constraints/basic_constraint_parts.hpp"

namespace trivium {

/// Phi = d_ij . d_ij - f(t) [m^2], f > 0.
template <class Scalar>
struct D : BodyPair {
  static constexpr const char* type = "d";
  static constexpr bool is_of_angle = false, sees_relative_motion = true, needs_positive_f = true;

  Vector3<Scalar> s_bar_i, s_bar_j;  ///< points of i and j [m, body frames]
  TimeFunction f;                    ///< squared distance [m^2]

  static void keys(auto&& show, auto&... c) {
    show.point_i(c.s_bar_i...);
    show.point_j(c.s_bar_j...);
    show.need("f", c.f...);
  }
  const TimeFunction& function() const { return f; }
  /// 2 |d_ij| = 2 sqrt(f) where Phi = 0: the change of Phi per metre [m].
  Scalar scale(const Scalar& t) const {
    using std::sqrt, std::abs;
    return 2 * sqrt(abs(f(t).f));
  }
  template <BodyKinematics Body, class Use>
  auto with_features(const Body& on_i, const Body& on_j, const Scalar& t, const Use& use) const {
    const PointOffsetFeature<Body> d(on_i, s_bar_i, on_j, s_bar_j);
    return use(d, d, f(t));
  }
};

}  // namespace trivium
