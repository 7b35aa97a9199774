#pragma once
/// The angle theta of a joint with one axis, from u_i to u_j about z_i, for effects that act about this axis.
/// theta is counted over full revolutions: its value lies within pi of the last counted angle.

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "bodies/numbers/lanewise.hpp"
#include "effects/effect.hpp"

namespace trivium {

/// The angle of a joint.
template <class Scalar>
struct JointAngle {
  int joint = 0;     ///< index of the joint in the mechanism, from which the members below are copied
  int i = 0, j = 0;  ///< indices of its bodies
  Vector3<Scalar> u_bar_i = Vector3<Scalar>::Zero(), v_bar_i = Vector3<Scalar>::Zero(),
                  z_bar_i = Vector3<Scalar>::Zero(), u_bar_j = Vector3<Scalar>::Zero();  ///< [-, body frames]
  Scalar tracked{0};  ///< last counted angle [rad]; at the start 2 pi times the initial revolutions
  bool operator==(const JointAngle&) const = default;

  /// Sets the last counted angle to `turns` full revolutions.
  void set_turns(int turns) { tracked = Scalar(2 * std::numbers::pi * turns); }
  /// The number of full revolutions nearest to theta [rad].
  static int turns_of(double theta) { return static_cast<int>(std::lround(theta / (2 * std::numbers::pi))); }

  /// Calls use(a.m, b.m, ...) for every member m, where a, b, ... are the given angles.
  template <class Use, class... Part>
  static void show_parts(const Use& use, Part&... p) {
    use(p.joint...);
    use(p.i...);
    use(p.j...);
    use(p.u_bar_i...);
    use(p.v_bar_i...);
    use(p.z_bar_i...);
    use(p.u_bar_j...);
    use(p.tracked...);
  }

  /// theta [rad], with theta - tracked in (-pi, pi].
  Scalar value(const EffectView<Scalar>& view) const {
    using std::atan2, std::cos, std::sin;
    const Matrix3<Scalar>& A_i = view.motion[i].A;
    const Vector3<Scalar> u_j = view.motion[j].A * u_bar_j;
    const Scalar y = u_j.dot(A_i * v_bar_i), x = u_j.dot(A_i * u_bar_i), c = cos(tracked), s = sin(tracked);
    return tracked + atan2(Scalar(y * c - x * s), Scalar(x * c + y * s));
  }
  /// theta' = z_i . (omega_j - omega_i) [rad/s].
  Scalar rate(const EffectView<Scalar>& view) const {
    const BodyMotion<Scalar>&bi = view.motion[i], &bj = view.motion[j];
    return axis(view).dot(bj.A * bj.omega_bar - bi.A * bi.omega_bar);
  }
  /// Adds the torque on_j z_i [N m] on body j and the opposite torque on body i.
  void add_torque(const Scalar& on_j, const EffectView<Scalar>& view,
                  std::span<Wrench<Scalar>> wrenches) const {
    const Vector3<Scalar> n = on_j * axis(view);
    wrenches[j].n_bar += view.motion[j].A.transpose() * n;
    wrenches[i].n_bar -= view.motion[i].A.transpose() * n;
  }
  /// The wrenches of torque -z_i on body i and z_i on body j: their power is theta'.
  std::pair<Wrench<Scalar>, Wrench<Scalar>> gradient(const EffectView<Scalar>& view) const {
    const Vector3<Scalar> z = axis(view);
    return {{Vector3<Scalar>::Zero(), -(view.motion[i].A.transpose() * z)},
            {Vector3<Scalar>::Zero(), view.motion[j].A.transpose() * z}};
  }

  /// Updates the last counted angle at an accepted state.
  void follow(const EffectView<Scalar>& view) {
    const Scalar theta = value(view), moved = theta - tracked;
    // `tracked` is updated only after theta has moved by 1 rad, since an update changes the rounding of theta
    tracked = select(moved * moved > Scalar(1), theta, tracked);
  }
  /// The time for 1 rad at the present rate [s]. After `follow` theta is within 1 rad of `tracked`. Even if
  /// the rate doubles during a step and theta moves by 2 rad, theta stays within 3 rad, less than pi, of
  /// `tracked`.
  Scalar longest_step(const EffectView<Scalar>& view) const {
    using std::abs;
    const Scalar speed = abs(rate(view)), never = std::numeric_limits<Scalar>::max();
    return speed == Scalar(0) ? never : Scalar(1 / speed);
  }

 private:
  Vector3<Scalar> axis(const EffectView<Scalar>& view) const { return view.motion[i].A * z_bar_i; }
};

}  // namespace trivium
