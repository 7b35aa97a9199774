#pragma once
/// Uniform gravity: the force m g at the centre of mass of every body, hence without a moment. Its potential
/// energy is the sum of -m g . r.
///
///     F = m g,   n_bar = 0,   V = -sum_b m_b g . r_b

#include <string>
#include <string_view>

#include "effects/effect.hpp"

namespace trivium {

/// Force m g on every body except the ground.
template <class Scalar>
struct Gravity {
  static constexpr std::string_view type = "gravity";
  static constexpr bool sees_motion = false;

  std::string name;
  Vector3<Scalar> acceleration = Vector3<Scalar>::Zero();  ///< g [m/s^2, global]
  bool operator==(const Gravity&) const = default;

  static void keys(auto&& show, auto&... e) { show.need("acceleration", e.acceleration...); }

  void apply(const EffectView<Scalar>& view, std::span<Wrench<Scalar>> wrenches) const {
    for (std::size_t b = 0; b < view.bodies.size(); ++b) wrenches[b].F += view.bodies[b].mass * acceleration;
  }
  Scalar power(const EffectView<Scalar>& view) const {
    Scalar sum(0);
    for (std::size_t b = 0; b < view.bodies.size(); ++b)
      sum += view.bodies[b].mass * acceleration.dot(view.motion[b].r_dot);
    return sum;
  }
  Scalar nonconservative_power(const EffectView<Scalar>&) const { return Scalar(0); }
  bool is_conservative() const { return true; }
  /// The sum of -m g . r over the bodies [J]; a body at the global origin has energy 0.
  Scalar potential_energy(const EffectView<Scalar>& view) const {
    Scalar sum(0);
    for (std::size_t b = 0; b < view.bodies.size(); ++b)
      sum -= view.bodies[b].mass * acceleration.dot(view.motion[b].r);
    return sum;
  }
};

static_assert(Effect<Gravity<double>, double>);

}  // namespace trivium
