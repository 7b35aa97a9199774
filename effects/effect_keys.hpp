#pragma once
/// The function `keys` of an effect presents its parts to a visitor, each with its key in a scene file. It
/// takes one effect, or several of one type whose corresponding parts are passed together. Casts, batches,
/// and the reader, writer, checks and random generator of scenes reach the parts by `keys` alone. A visitor
/// has
///
///     body(key, index...)      the body on which a load acts
///     point(key, point...)     a point of a body (BodyPoint): an object with `body` and `point` in a file
///     joint(key, angle...)     the angle of a joint (JointAngle)
///     need(key, value...)      a number, a vector, a function of time, three functions of time, or a frame
///     may(key, value...)       the same, but optional in a file
///     place(key, s_bar...), angle(key, angle...)
///                              a position [m] or an angle [rad], optional; values too small for the Scalar
///                              become 0, whereas with `need` and `may` they are an error
///     turns(key, angle...)     the full revolutions at the start, a part of the angle passed to `joint`
///
/// Optional parts are 0, or the global frame, if a file omits them; members must have these initial values.

#include <string_view>

namespace trivium {

/// A base class for visitors: every member does nothing.
struct KeyVisitor {
  void body(std::string_view, auto&...) const {}
  void point(std::string_view, auto&...) const {}
  void joint(std::string_view, auto&...) const {}
  void need(std::string_view, auto&...) const {}
  void may(std::string_view, auto&...) const {}
  void place(std::string_view, auto&...) const {}
  void angle(std::string_view, auto&...) const {}
  void turns(std::string_view, auto&...) const {}
};

/// A base class (CRTP) for visitors that treat all values alike, by a member value(key, value...).
template <class Visitor>
struct ValueVisitor {
  void need(std::string_view key, auto&... value) { visitor().value(key, value...); }
  void may(std::string_view key, auto&... value) { visitor().value(key, value...); }
  void place(std::string_view key, auto&... value) { visitor().value(key, value...); }
  void angle(std::string_view key, auto&... value) { visitor().value(key, value...); }
  void turns(std::string_view, auto&...) const {}

 private:
  Visitor& visitor() { return static_cast<Visitor&>(*this); }
};

/// A visitor that calls use(part...) for every part, also for the members of points and joint angles.
template <class Use>
struct EffectParts : ValueVisitor<EffectParts<Use>> {
  const Use& use;

  explicit EffectParts(const Use& visitor) : use(visitor) {}

  void body(std::string_view, auto&... index) const { use(index...); }
  template <class Point, class... Points>
  void point(std::string_view, Point& point, Points&... points) const {
    Point::show_parts(use, point, points...);
  }
  template <class Angle, class... Angles>
  void joint(std::string_view, Angle& angle, Angles&... angles) const {
    Angle::show_parts(use, angle, angles...);
  }
  void value(std::string_view, auto&... value) const { use(value...); }
};

/// Calls use(part...) for every part of one effect, or of several of one type.
template <class Use, class E, class... Others>
void show_effect_parts(const Use& use, E& effect, Others&... others) {
  E::keys(EffectParts<Use>(use), effect, others...);
}

}  // namespace trivium
