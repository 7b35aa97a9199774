#pragma once
/// A torque with given components on a body. A torque has no potential, even if its components are constant:
/// its work over a finite rotation depends on the path. The wrench on the body is
///
///     F = 0,   n_bar (body frame; A^T n if given in the global frame),   power n_bar . omega_bar

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "effects/effect.hpp"
#include "effects/effect_parts.hpp"

namespace trivium {

/// Torque n(t) on a body.
template <class Scalar>
struct Torque {
  static constexpr std::string_view type = "torque";

  std::string name;
  int body = 0;                            ///< index of the body
  std::array<TimeFunction, 3> components;  ///< torque components in `frame` [N m]
  ComponentFrame frame = ComponentFrame::global;
  bool operator==(const Torque&) const = default;

  static void keys(auto&& show, auto&... e) {
    show.body("body", e.body...);
    show.need("torque", e.components...);
    show.may("frame", e.frame...);
  }

  void apply(const EffectView<Scalar>& view, std::span<Wrench<Scalar>> wrenches) const {
    wrenches[body].n_bar += body_torque(view);
  }
  Scalar power(const EffectView<Scalar>& view) const {
    return body_torque(view).dot(view.motion[body].omega_bar);
  }
  Scalar potential_energy(const EffectView<Scalar>&) const { return Scalar(0); }
  Scalar nonconservative_power(const EffectView<Scalar>& view) const { return power(view); }
  void append_kinks(std::vector<double>& times) const { trivium::append_kinks(components, times); }
  bool is_conservative() const { return false; }

 private:
  Vector3<Scalar> body_torque(const EffectView<Scalar>& view) const {
    const Vector3<Scalar> n = evaluate(components, view.t);
    return frame == ComponentFrame::body ? n : Vector3<Scalar>(view.motion[body].A.transpose() * n);
  }
};

static_assert(Effect<Torque<double>, double>);

}  // namespace trivium
