#pragma once
/// The four basic constraints as data (Haug 1989, section 9.4):
///
///   DP1  a_i . a_j - f(t)      DP2  a_i . d_ij - f(t)      D  d_ij . d_ij - f(t)      CD  c . d_ij - f(t)
///
/// and DP1 with a vector that turns by itself in body i (rotation drivers). Their equations are in
/// constraint_row.hpp. The scale of a row, by which tolerances of length and of angle apply to all five, is
/// decided here.

#include <cmath>
#include <variant>

#include "bodies/numbers/time_function.hpp"
#include "bodies/numbers/vectors.hpp"

namespace trivium {

/// The bodies of a row: indices into the mechanism's bodies, the last of which is the ground.
struct BodyPair {
  int i = 0, j = 0;

  /// use(part...) for every part of one pair or of several side by side.
  template <class Use, class... Part>
  static void show_parts(const Use& use, Part&... p) {
    use(p.i...);
    use(p.j...);
  }
};

template <class Scalar>
struct DP1 : BodyPair {
  Vector3<Scalar> a_bar_i, a_bar_j;
  TimeFunction f;

  /// use(part...) for every part of one row or of several side by side.
  template <class Use, class... Part>
  static void show_parts(const Use& use, Part&... p) {
    BodyPair::show_parts(use, p...);
    use(p.a_bar_i...);
    use(p.a_bar_j...);
    use(p.f...);
  }
};

/// DP1 whose first vector is w_i(t) = -sin alpha(t) u_i + cos alpha(t) v_i, f = 0.
template <class Scalar>
struct TurningDP1 : BodyPair {
  Vector3<Scalar> u_bar_i, v_bar_i, a_bar_j;
  TimeFunction alpha;

  /// use(part...) for every part of one row or of several side by side.
  template <class Use, class... Part>
  static void show_parts(const Use& use, Part&... p) {
    BodyPair::show_parts(use, p...);
    use(p.u_bar_i...);
    use(p.v_bar_i...);
    use(p.a_bar_j...);
    use(p.alpha...);
  }
};

template <class Scalar>
struct DP2 : BodyPair {
  Vector3<Scalar> a_bar_i, s_bar_i, s_bar_j;
  TimeFunction f;

  /// use(part...) for every part of one row or of several side by side.
  template <class Use, class... Part>
  static void show_parts(const Use& use, Part&... p) {
    BodyPair::show_parts(use, p...);
    use(p.a_bar_i...);
    use(p.s_bar_i...);
    use(p.s_bar_j...);
    use(p.f...);
  }
};

template <class Scalar>
struct D : BodyPair {
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
};

template <class Scalar>
struct CD : BodyPair {
  Vector3<Scalar> c, s_bar_i, s_bar_j;
  TimeFunction f;

  /// use(part...) for every part of one row or of several side by side.
  template <class Use, class... Part>
  static void show_parts(const Use& use, Part&... p) {
    BodyPair::show_parts(use, p...);
    use(p.c...);
    use(p.s_bar_i...);
    use(p.s_bar_j...);
    use(p.f...);
  }
};

template <class Scalar>
using BasicConstraint = std::variant<DP1<Scalar>, TurningDP1<Scalar>, DP2<Scalar>, D<Scalar>, CD<Scalar>>;

/// f(t), or alpha(t) of a turning vector.
template <class Scalar>
const TimeFunction& function_of(const BasicConstraint<Scalar>& constraint) {
  return std::visit(
      [](const auto& c) -> const TimeFunction& {
        if constexpr (requires { c.alpha; })
          return c.alpha;
        else
          return c.f;
      },
      constraint);
}

template <class Scalar>
BodyPair bodies_of(const BasicConstraint<Scalar>& constraint) {
  return std::visit([](const BodyPair& pair) { return pair; }, constraint);
}

/// How much Phi of one constraint, where it holds, changes per metre of its points or radian of its vectors:
/// |a_i| |a_j| (DP1), |a_i| (DP2), 2 |d| (D), |c| (CD); 1 where that is zero.
template <class Scalar>
Scalar row_scale(const BasicConstraint<Scalar>& constraint, const Scalar& t) {
  using std::sqrt, std::abs;
  struct Scale {
    const Scalar& t;
    Scalar operator()(const DP1<Scalar>& c) const { return c.a_bar_i.norm() * c.a_bar_j.norm(); }
    Scalar operator()(const TurningDP1<Scalar>& c) const { return c.u_bar_i.norm() * c.a_bar_j.norm(); }
    Scalar operator()(const DP2<Scalar>& c) const { return c.a_bar_i.norm(); }
    Scalar operator()(const D<Scalar>& c) const { return 2 * sqrt(abs(c.f(t).f)); }
    Scalar operator()(const CD<Scalar>& c) const { return c.c.norm(); }
  };
  const Scalar scale = std::visit(Scale{t}, constraint);
  return scale > Scalar(0) ? scale : Scalar(1);
}

/// Whether Phi, over its scale, is an angle [rad]; a length [m] where it is not.
template <class Scalar>
bool is_of_angle(const BasicConstraint<Scalar>& constraint) {
  return std::holds_alternative<DP1<Scalar>>(constraint) ||
         std::holds_alternative<TurningDP1<Scalar>>(constraint);
}

}  // namespace trivium
