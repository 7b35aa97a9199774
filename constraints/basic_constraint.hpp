#pragma once
/// The basic constraints (Haug 1989, section 9.4), each in a file of its own, and the one list of them:
///
///   DP1  a_i . a_j - f(t)      DP2  a_i . d_ij - f(t)      D  d_ij . d_ij - f(t)      CD  c . d_ij - f(t)
///
/// and DP1 with a vector that turns by itself in body i (rotation drivers). Each is a dot product of two
/// features, less a function of time; its equations follow in constraint_row.hpp, in every formulation. To
/// add one, write its file and enter it here; outside the library, add it by `With`.

#include <concepts>
#include <type_traits>
#include <variant>

#include "constraints/cd.hpp"
#include "constraints/constraint_keys.hpp"
#include "constraints/constraint_type.hpp"
#include "constraints/d.hpp"
#include "constraints/dp1.hpp"
#include "constraints/dp2.hpp"
#include "constraints/plain_body.hpp"
#include "constraints/turning_dp1.hpp"

namespace trivium {

/// What a basic constraint has: its bodies (BodyPair), and
///
///   keys           shows every one of its parts (constraint_keys.hpp)
///   is_of_angle    whether Phi, over its scale, is an angle [rad]; a length [m] where it is not
///   scale          at t: how much Phi, where it holds, changes per metre of its points or radian of its
///                  vectors
///   function       f(t), or what else moves the row by itself
///   with_features  from (on_i, on_j, t, use): use(x, y, f) of its two features and f, with Phi = x . y - f;
///                  over all kinds of bodies (BodyKinematics)
///
/// It may have
///
///   type           what a scene file calls it; without one, no file does
///   sees_relative_motion
///                  whether it sees how j moves relative to i and nothing else; if not said, it may see more
///   needs_positive_f
///                  whether it has no gradient, or nothing to hold, where f is 0
///   vanishes       from (on_i, on_j, share): whether it does less here than that share of what its vectors
///                  could
template <class C, class Scalar>
concept DotProductConstraint = std::derived_from<C, BodyPair> && requires(const C& c, const Scalar& t) {
  { C::is_of_angle } -> std::convertible_to<bool>;
  { c.scale(t) } -> std::convertible_to<Scalar>;
  { c.function() } -> std::convertible_to<const TimeFunction&>;
  show_constraint_parts([](const auto&...) {}, c);
  c.with_features(PlainBody<Scalar>(), PlainBody<Scalar>(), t,
                  [](const auto&, const auto&, const Jet<Scalar>&) {});
};

/// A list of basic constraints, over any Scalar.
template <template <class> class... C>
struct BasicConstraints {
  static_assert((DotProductConstraint<C<double>, double> && ...));

  template <class Scalar>
  using In = std::variant<C<Scalar>...>;
  template <template <class> class... More>
  using With = BasicConstraints<C..., More...>;

  /// Where X stands in the list; the list's length where it does not.
  template <template <class> class X>
  static constexpr int place_of = [] {
    int place = 0;
    (void)((std::is_same_v<C<double>, X<double>> || (++place, false)) || ...);
    return place;
  }();
};

/// The list of the library.
using StandardConstraints = BasicConstraints<DP1, TurningDP1, DP2, D, CD>;

template <class Scalar, class List = StandardConstraints>
using BasicConstraint = typename List::template In<Scalar>;

/// The type of a scene's constraint that is a basic one.
template <template <class> class C>
inline constexpr ConstraintType basic_type{JointType::basic, StandardConstraints::place_of<C>};

// of one of any list
template <class... C>
const TimeFunction& function_of(const std::variant<C...>& constraint) {
  return std::visit([](const auto& c) -> const TimeFunction& { return c.function(); }, constraint);
}
template <class... C>
BodyPair bodies_of(const std::variant<C...>& constraint) {
  return std::visit([](const BodyPair& pair) { return pair; }, constraint);
}
/// 1 where the constraint's own is zero.
template <class Scalar, class... C>
Scalar row_scale(const std::variant<C...>& constraint, const Scalar& t) {
  const Scalar scale = std::visit([&](const auto& c) { return Scalar(c.scale(t)); }, constraint);
  return scale == Scalar(0) ? Scalar(1) : scale;
}
template <class... C>
bool is_of_angle(const std::variant<C...>& constraint) {
  return std::visit([](const auto& c) { return c.is_of_angle; }, constraint);
}
template <class... C>
bool sees_relative_motion(const std::variant<C...>& constraint) {
  const auto says = []<class One>(const One&) {
    if constexpr (requires { One::sees_relative_motion; })
      return One::sees_relative_motion;
    else
      return false;
  };
  return std::visit(says, constraint);
}

}  // namespace trivium
