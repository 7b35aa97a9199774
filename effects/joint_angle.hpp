#pragma once
/// The angle theta of a joint with one axis, from u_i to u_j about z_i, for effects that act about it.
/// Decided here: theta is counted over full turns, within half a turn of where it was last.

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "bodies/numbers/lanewise.hpp"
#include "effects/effect.hpp"

namespace trivium {

template <class Scalar>
struct JointAngle {
  int joint = 0;  ///< which of the mechanism's; what follows is taken from there
  int i = 0, j = 0;
  Vector3<Scalar> u_bar_i = Vector3<Scalar>::Zero(), v_bar_i = Vector3<Scalar>::Zero(),
                  z_bar_i = Vector3<Scalar>::Zero(), u_bar_j = Vector3<Scalar>::Zero();  ///< body frames
  Scalar tracked{0};  ///< where theta was last [rad]; full turns at the start
  bool operator==(const JointAngle&) const = default;

  void set_turns(int turns) { tracked = Scalar(2 * std::numbers::pi * turns); }
  /// Those nearest to an angle [rad]: the angle is within half a turn of them.
  static int turns_of(double theta) { return static_cast<int>(std::lround(theta / (2 * std::numbers::pi))); }

  /// use(part...) for every part of one angle or of several side by side.
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

  /// theta [rad], in (-pi, pi] of where it was last (of full turns at the start).
  Scalar value(const EffectView<Scalar>& view) const {
    using std::atan2, std::cos, std::sin;
    const Matrix3<Scalar>& A_i = view.motion[i].A;
    const Vector3<Scalar> u_j = view.motion[j].A * u_bar_j;
    const Scalar y = u_j.dot(A_i * v_bar_i), x = u_j.dot(A_i * u_bar_i), c = cos(tracked), s = sin(tracked);
    return tracked + atan2(Scalar(y * c - x * s), Scalar(x * c + y * s));
  }
  /// theta' = z . (omega_j - omega_i).
  Scalar rate(const EffectView<Scalar>& view) const {
    const BodyMotion<Scalar>&bi = view.motion[i], &bj = view.motion[j];
    return axis(view).dot(bj.A * bj.omega_bar - bi.A * bi.omega_bar);
  }
  /// A torque about z on j, and the opposite on i.
  void add_torque(const Scalar& on_j, const EffectView<Scalar>& view,
                  std::span<Wrench<Scalar>> wrenches) const {
    const Vector3<Scalar> n = on_j * axis(view);
    wrenches[j].n_bar += view.motion[j].A.transpose() * n;
    wrenches[i].n_bar -= view.motion[i].A.transpose() * n;
  }
  /// What a torque of 1 does to i and to j.
  std::pair<Wrench<Scalar>, Wrench<Scalar>> gradient(const EffectView<Scalar>& view) const {
    const Vector3<Scalar> z = axis(view);
    return {{Vector3<Scalar>::Zero(), -(view.motion[i].A.transpose() * z)},
            {Vector3<Scalar>::Zero(), view.motion[j].A.transpose() * z}};
  }

  /// From now on theta is counted from where it is, over full turns.
  void follow(const EffectView<Scalar>& view) {
    const Scalar theta = value(view), moved = theta - tracked;
    tracked = select(moved * moved > Scalar(1), theta, tracked);  // seldom: every sum is rounded
  }
  /// A radian [s]; beside what `follow` leaves, twice as far is still within half a turn.
  Scalar longest_step(const EffectView<Scalar>& view) const {
    using std::abs;
    const Scalar speed = abs(rate(view)), never = std::numeric_limits<Scalar>::max();
    return speed == Scalar(0) ? never : Scalar(1 / speed);
  }

 private:
  Vector3<Scalar> axis(const EffectView<Scalar>& view) const { return view.motion[i].A * z_bar_i; }
};

}  // namespace trivium
