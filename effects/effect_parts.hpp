#pragma once
/// Parts of effects: a point of a body, three components of a force or torque as functions of time, and the
/// frame of these components. The angle of a joint is in joint_angle.hpp.

#include <array>
#include <vector>

#include "bodies/numbers/time_function.hpp"
#include "bodies/numbers/vectors.hpp"

namespace trivium {

/// A point fixed in a body.
template <class Scalar>
struct BodyPoint {
  int body = 0;  ///< index of the body, below the number of bodies nb; the index nb is the ground
  Vector3<Scalar> s_bar = Vector3<Scalar>::Zero();  ///< from the centre of mass to the point [m, body frame]
  bool operator==(const BodyPoint&) const = default;

  /// Calls use(a.m, b.m, ...) for every member m, where a, b, ... are the given points.
  template <class Use, class... Part>
  static void show_parts(const Use& use, Part&... p) {
    use(p.body...);
    use(p.s_bar...);
  }
};

/// The frame in which the three components of a force or torque are given.
enum class ComponentFrame { global, body };

/// The values of three components at time t [s].
template <class Scalar>
Vector3<Scalar> evaluate(const std::array<TimeFunction, 3>& components, const Scalar& t) {
  return {components[0](t).f, components[1](t).f, components[2](t).f};
}

/// Appends the times at which the components have kinks.
inline void append_kinks(const std::array<TimeFunction, 3>& components, std::vector<double>& times) {
  for (const TimeFunction& component : components) component.append_kinks(times);
}

}  // namespace trivium
