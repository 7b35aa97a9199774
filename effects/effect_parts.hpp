#pragma once
/// What effects are made of besides numbers: a point of a body, the three components of a force or a torque
/// as functions of time, and the frame that they are meant in. A joint's angle is in joint_angle.hpp.

#include <array>
#include <vector>

#include "bodies/numbers/time_function.hpp"
#include "bodies/numbers/vectors.hpp"

namespace trivium {

template <class Scalar>
struct BodyPoint {
  int body = 0;
  Vector3<Scalar> s_bar = Vector3<Scalar>::Zero();  ///< [m, body frame]
  bool operator==(const BodyPoint&) const = default;

  /// use(part...) for every part of one point or of several side by side.
  template <class Use, class... Part>
  static void show_parts(const Use& use, Part&... p) {
    use(p.body...);
    use(p.s_bar...);
  }
};

/// The frame that given components are meant in.
enum class ComponentFrame { global, body };

/// The components at time t.
template <class Scalar>
Vector3<Scalar> evaluate(const std::array<TimeFunction, 3>& components, const Scalar& t) {
  return {components[0](t).f, components[1](t).f, components[2](t).f};
}

/// Appends the times where they have kinks.
inline void append_kinks(const std::array<TimeFunction, 3>& components, std::vector<double>& times) {
  for (const TimeFunction& component : components) component.append_kinks(times);
}

}  // namespace trivium
