#pragma once
/// A force with given components at a body-fixed point P. Only a force whose global components are plain
/// numbers has a potential, V = -F . r_P; any other force counts as nonconservative. The wrench on the body
/// is
///
///     F (global; A F_bar if given in the body frame),   n_bar = s_bar_P x A^T F

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "effects/effect.hpp"
#include "effects/effect_parts.hpp"

namespace trivium {

/// Force F(t) at a point of a body.
template <class Scalar>
struct Force {
  static constexpr std::string_view type = "force";

  std::string name;
  int body = 0;                                     ///< index of the body
  Vector3<Scalar> s_bar = Vector3<Scalar>::Zero();  ///< point of application P [m, body frame]
  std::array<TimeFunction, 3> components;           ///< force components in `frame` [N]
  ComponentFrame frame = ComponentFrame::global;
  bool operator==(const Force&) const = default;

  static void keys(auto&& show, auto&... e) {
    show.body("body", e.body...);
    show.place("point", e.s_bar...);
    show.need("force", e.components...);
    show.may("frame", e.frame...);
  }

  void apply(const EffectView<Scalar>& view, std::span<Wrench<Scalar>> wrenches) const {
    wrenches[body].add_force(global_force(view), view.motion[body].A, s_bar);
  }
  Scalar power(const EffectView<Scalar>& view) const {
    return global_force(view).dot(view.motion[body].point_velocity(s_bar));
  }
  /// -F . r_P [J] if the global components are plain numbers, otherwise 0.
  Scalar potential_energy(const EffectView<Scalar>& view) const {
    if (!is_conservative()) return Scalar(0);
    return -global_force(view).dot(view.motion[body].point(s_bar));
  }
  Scalar nonconservative_power(const EffectView<Scalar>& view) const {
    return is_conservative() ? Scalar(0) : power(view);
  }
  void append_kinks(std::vector<double>& times) const { trivium::append_kinks(components, times); }
  bool is_conservative() const {
    return frame == ComponentFrame::global && components[0].is_number() && components[1].is_number() &&
           components[2].is_number();
  }

 private:
  Vector3<Scalar> global_force(const EffectView<Scalar>& view) const {
    const Vector3<Scalar> F = evaluate(components, view.t);
    return frame == ComponentFrame::global ? F : Vector3<Scalar>(view.motion[body].A * F);
  }
};

static_assert(Effect<Force<double>, double>);

}  // namespace trivium
