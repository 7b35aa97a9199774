#pragma once
/// D: d_ij . d_ij - f(t), the square of the distance between a point on each body (Haug 1989, section 9.4).
/// f > 0: at distance 0 the row has no gradient.

#include <cmath>

#include "constraints/basic_constraint_parts.hpp"

namespace trivium {

template <class Scalar>
struct D : BodyPair {
  static constexpr const char* name = "D";
  static constexpr bool is_of_angle = false;

  Vector3<Scalar> s_bar_i, s_bar_j;
  TimeFunction f;

  /// use(part...) for every part of one row or of several side by side.
  template <class Use, class... Part>
  static void show_parts(const Use& use, Part&... p) {
    BodyPair::show_parts(use, p...);
    use(p.s_bar_i...);
    use(p.s_bar_j...);
    use(p.f...);
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
