#pragma once
/// A spring, damper and actuator about the axis z of a joint (Haug 1989, rotational spring-damper-actuator).
/// theta is the angle from u_i to u_j about z_i (joint_angle.hpp). The torques on bodies j and i are
///
///     n_j = -(k (theta - theta0) + c theta' + h(t)) z_i [N m],   n_i = -n_j

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bodies/numbers/lanewise.hpp"
#include "bodies/numbers/time_function.hpp"
#include "effects/effect.hpp"
#include "effects/joint_angle.hpp"

namespace trivium {

/// Torque -(k (theta - theta0) + c theta' + h(t)) on body j about the joint axis z, the opposite on i.
template <class Scalar>
struct TorsionalSpringDamper {
  static constexpr std::string_view type = "torsional_spring_damper";

  std::string name;
  JointAngle<Scalar> angle;                        ///< theta, the angle of the joint
  Scalar stiffness{0}, damping{0}, free_angle{0};  ///< k [N m/rad], c [N m s/rad], theta0 [rad]
  TimeFunction actuator;                           ///< h [N m]
  bool operator==(const TorsionalSpringDamper&) const = default;

  static void keys(auto&& show, auto&... e) {
    show.joint("joint", e.angle...);
    show.may("stiffness", e.stiffness...);
    show.may("damping", e.damping...);
    show.angle("free_angle", e.free_angle...);
    show.may("actuator", e.actuator...);
    show.turns("turns", e.angle...);
  }

  void apply(const EffectView<Scalar>& view, std::span<Wrench<Scalar>> wrenches) const {
    angle.add_torque(torque_on_j(view), view, wrenches);
  }
  Scalar power(const EffectView<Scalar>& view) const { return torque_on_j(view) * angle.rate(view); }
  /// k (theta - theta0)^2 / 2 [J].
  Scalar potential_energy(const EffectView<Scalar>& view) const {
    const Scalar twist = angle.value(view) - free_angle;
    return stiffness * twist * twist / 2;
  }
  /// The power of the damper and the actuator, -(c theta' + h) theta' [W].
  Scalar nonconservative_power(const EffectView<Scalar>& view) const {
    const Scalar rate = angle.rate(view);
    return -(damping * rate + actuator(view.t).f) * rate;
  }
  /// Whether damping and actuator are 0.
  bool is_conservative() const { return all(damping == Scalar(0)) && actuator == TimeFunction(0); }
  void append_kinks(std::vector<double>& times) const { actuator.append_kinks(times); }
  void follow(const EffectView<Scalar>& view) { angle.follow(view); }
  Scalar longest_step(const EffectView<Scalar>& view) const { return angle.longest_step(view); }

  std::pair<int, int> bodies() const { return {angle.i, angle.j}; }
  /// The gradient of theta: wrenches on i and j whose power is theta'.
  std::pair<Wrench<Scalar>, Wrench<Scalar>> gradient(const EffectView<Scalar>& view) const {
    return angle.gradient(view);
  }
  /// |k| times 10 rad plus |c| times the sum of both angular velocities [N m]. 10 rad stands for |theta| +
  /// |theta0| within one revolution, at most pi + 2 pi; a spring that is wound up by many revolutions has
  /// larger rounding errors than this scale.
  Scalar tension_scale(const EffectView<Scalar>& view) const {
    using std::abs;
    return abs(stiffness) * Scalar(10) +
           abs(damping) * (view.motion[angle.i].omega_bar.norm() + view.motion[angle.j].omega_bar.norm());
  }

 private:
  Scalar torque_on_j(const EffectView<Scalar>& view) const {
    return -(stiffness * (angle.value(view) - free_angle) + damping * angle.rate(view) + actuator(view.t).f);
  }
};

static_assert(Effect<TorsionalSpringDamper<double>, double>);

}  // namespace trivium
