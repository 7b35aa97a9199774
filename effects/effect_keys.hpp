#pragma once
/// How an effect shows its parts, each with the key that a scene file has for it: of one effect, or of
/// several of one type side by side. Casts and batches, reader, writer, checks and random scenes go by this
/// alone. A visitor has
///
///   body(key, index...)    the body that a load acts on
///   point(key, point...)   a body and a point of it (BodyPoint): an object with `body` and `point`
///   joint(key, angle...)   a joint with an angle (JointAngle)
///   need(key, value...), may(key, value...)
///                          a number, vector, function of time, three of these, or a frame
///   place(key, s_bar...), angle(key, angle...)
///                          a vector or number whose size alone says nothing: near zero it counts as zero
///   turns(key, angle...)   full turns that the angle of a joint begins with (JointAngle), a part of `joint`
///
/// What `may`, `place` and `angle` show is 0, or the global frame, where a file says nothing: so must the
/// members begin.

#include <string_view>

namespace trivium {

/// Does nothing: what is common to visitors.
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

/// For a visitor to whom all values are alike: visitor.value(key, value...).
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

/// use(part...) for every part.
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

/// use(part...) for every part of one effect or of several of its type.
template <class Use, class E, class... Others>
void show_effect_parts(const Use& use, E& effect, Others&... others) {
  E::keys(EffectParts<Use>(use), effect, others...);
}

}  // namespace trivium
