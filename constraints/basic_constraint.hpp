#pragma once
/// The list of the basic constraints (Haug 1989, section 9.4) and the concept that they satisfy:
///
///     DP1  a_i . a_j - f(t)     DP2  a_i . d_ij - f(t)     D  d_ij . d_ij - f(t)     CD  c . d_ij - f(t)
///
/// and TurningDP1, a DP1 whose first vector rotates relative to body i (rotation drivers). Each has its own
/// file. Each is the dot product of two features (feature.hpp) minus a function of time; constraint_row.hpp
/// derives the equations of every formulation from this product. To add a constraint, write its file and
/// enter the type in StandardConstraints; a project outside the library adds its type by `With`.

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

/// A basic constraint. It derives from BodyPair and must have
///
///     keys           presents each of its parts to a visitor (constraint_keys.hpp)
///     is_of_angle    true if Phi / scale measures an angle [rad], false if it measures a length [m]
///     scale(t)       row of a length: |dPhi| per metre of motion of its points, where Phi = 0; row of
///                    an angle: the largest |dPhi| per radian of rotation. Phi / scale is comparable
///                    between rows
///     function       its function of time: f(t), or alpha(t) of TurningDP1
///     with_features  (on_i, on_j, t, use): returns use(x, y, f), its two features and f of Phi = x . y - f;
///                    on_i and on_j are bodies of any formulation (BodyKinematics)
///
/// It may have
///
///     type           its name in scene files; without it, scene files cannot contain the constraint
///     sees_relative_motion
///                    true if Phi depends only on the pose of j relative to i; default false
///     needs_positive_f
///                    true if the row has no gradient, or cannot hold, at f = 0: scene files need f > 0
///     vanishes       (on_i, on_j, share): true if the gradient at this state is less than `share` of the
///                    largest gradient that vectors of these lengths can have
template <class C, class Scalar>
concept DotProductConstraint = std::derived_from<C, BodyPair> && requires(const C& c, const Scalar& t) {
  { C::is_of_angle } -> std::convertible_to<bool>;
  { c.scale(t) } -> std::convertible_to<Scalar>;
  { c.function() } -> std::convertible_to<const TimeFunction&>;
  show_constraint_parts([](const auto&...) {}, c);
  c.with_features(PlainBody<Scalar>(), PlainBody<Scalar>(), t,
                  [](const auto&, const auto&, const Jet<Scalar>&) {});
};

/// A list of types of basic constraints, for any Scalar: `In<Scalar>` is a variant of them.
template <template <class> class... C>
struct BasicConstraints {
  static_assert((DotProductConstraint<C<double>, double> && ...));

  /// A constraint of any type of the list.
  template <class Scalar>
  using In = std::variant<C<Scalar>...>;
  /// The list with more types at its end.
  template <template <class> class... More>
  using With = BasicConstraints<C..., More...>;

  /// Index of X in the list (from 0); the length of the list if X is not in it.
  template <template <class> class X>
  static constexpr int place_of = [] {
    int place = 0;
    (void)((std::is_same_v<C<double>, X<double>> || (++place, false)) || ...);
    return place;
  }();
};

/// The basic constraints of the library.
using StandardConstraints = BasicConstraints<DP1, TurningDP1, DP2, D, CD>;

/// A basic constraint of any type of the list, over one Scalar.
template <class Scalar, class List = StandardConstraints>
using BasicConstraint = typename List::template In<Scalar>;

/// The ConstraintType of the basic constraint C.
template <template <class> class C>
inline constexpr ConstraintType basic_type{JointType::basic, StandardConstraints::place_of<C>};

/// The function of time, f(t) or alpha(t), of a constraint of any type.
template <class... C>
const TimeFunction& function_of(const std::variant<C...>& constraint) {
  return std::visit([](const auto& c) -> const TimeFunction& { return c.function(); }, constraint);
}
/// The two bodies of a constraint of any type.
template <class... C>
BodyPair bodies_of(const std::variant<C...>& constraint) {
  return std::visit([](const BodyPair& pair) { return pair; }, constraint);
}
/// scale(t) of the constraint as a divisor for Phi, hence 1 if scale(t) is 0. NaN stays NaN.
template <class Scalar, class... C>
Scalar row_scale(const std::variant<C...>& constraint, const Scalar& t) {
  const Scalar scale = std::visit([&](const auto& c) { return Scalar(c.scale(t)); }, constraint);
  return scale == Scalar(0) ? Scalar(1) : scale;
}
/// Whether Phi / scale of a constraint measures an angle [rad]; otherwise it measures a length [m].
template <class... C>
bool is_of_angle(const std::variant<C...>& constraint) {
  return std::visit([](const auto& c) { return c.is_of_angle; }, constraint);
}
/// Whether Phi depends only on the pose of j relative to i; false if the constraint does not declare this.
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
