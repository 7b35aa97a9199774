#pragma once
/// D: d_ij . d_ij - f(t), the square of the distance between a point on each body (Haug 1989, section 9.4).
/// f > 0: at distance 0 the row has no gradient.

#include <cmath>

#include "constraints/basic_constraint_parts.hpp"

namespace trivium {

template <class Scalar>
struct D : BodyPair {
  static constexpr const char* type = "d";
  static constexpr bool is_of_angle = false, sees_relative_motion = true, needs_positive_f = true;

  Vector3<Scalar> s_bar_i, s_bar_j;
  TimeFunction f;

  static void keys(auto&& show, auto&... c) {
    show.point_i(c.s_bar_i...);
    show.point_j(c.s_bar_j...);
    show.need("f", c.f...);
  }
  const TimeFunction& function() const { return f; }
  /// 2 |d|, where the row holds.
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
