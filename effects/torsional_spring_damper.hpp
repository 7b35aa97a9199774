#pragma once
/// A spring, damper and actuator about a joint's axis: torque on body j -(k (theta - theta0) + c theta' +
/// h(t)) along z, the opposite on body i. theta turns from u_i to u_j about z_i.
/// Decided here: theta is counted over full turns, within half a turn of where it was last.

#include <cmath>
#include <limits>
#include <utility>

#include "bodies/numbers/lanewise.hpp"
#include "bodies/numbers/time_function.hpp"
#include "effects/effect.hpp"

namespace trivium {

template <class Scalar>
struct TorsionalSpringDamper {
  int i = 0, j = 0;
  Vector3<Scalar> u_bar_i, v_bar_i, z_bar_i, u_bar_j;  ///< of its joint, body frames
  Scalar stiffness{0}, damping{0}, free_angle{0};      ///< k [N m/rad], c [N m s/rad], theta0 [rad]
  TimeFunction actuator;                               ///< h [N m]
  Scalar tracked_angle{0};  ///< where theta was last: theta is counted within half a turn of it

  /// use(part...) for every part of one effect or of several side by side.
  template <class Use, class... Part>
  static void show_parts(const Use& use, Part&... p) {
    use(p.i...);
    use(p.j...);
    use(p.u_bar_i...);
    use(p.v_bar_i...);
    use(p.z_bar_i...);
    use(p.u_bar_j...);
    use(p.stiffness...);
    use(p.damping...);
    use(p.free_angle...);
    use(p.actuator...);
    use(p.tracked_angle...);
  }

  void apply(const EffectView<Scalar>& view, std::span<Wrench<Scalar>> wrenches) const {
    const Vector3<Scalar> n = torque_on_j(view) * axis(view);
    wrenches[j].n_bar += view.motion[j].A.transpose() * n;
    wrenches[i].n_bar -= view.motion[i].A.transpose() * n;
  }
  Scalar power(const EffectView<Scalar>& view) const { return torque_on_j(view) * angle_rate(view); }
  /// k (theta - theta0)^2 / 2.
  Scalar potential_energy(const EffectView<Scalar>& view) const {
    const Scalar twist = angle(view) - free_angle;
    return stiffness * twist * twist / 2;
  }

  /// That of the damper and the actuator.
  Scalar nonconservative_power(const EffectView<Scalar>& view) const {
    const Scalar rate = angle_rate(view);
    return -(damping * rate + actuator(view.t).f) * rate;
  }
  void append_kinks(std::vector<double>& times) const { actuator.append_kinks(times); }
  /// Zero damping and no actuator.
  bool is_conservative() const { return all(damping == Scalar(0)) && actuator == TimeFunction(0); }
  /// From now on theta is counted from where it is, over full turns.
  void follow(const EffectView<Scalar>& view) {
    const Scalar theta = angle(view), moved = theta - tracked_angle;
    tracked_angle = select(moved * moved > Scalar(1), theta, tracked_angle);  // seldom: every sum is rounded
  }

  /// A radian [s]; beside what `follow` leaves, twice as far is still within half a turn.
  Scalar longest_step(const EffectView<Scalar>& view) const {
    using std::abs;
    const Scalar rate = abs(angle_rate(view)), never = std::numeric_limits<Scalar>::max();
    return rate > Scalar(0) ? Scalar(1 / rate) : never;
  }

  /// theta, in (-pi, pi] of tracked_angle (0 at the start).
  Scalar angle(const EffectView<Scalar>& view) const {
    using std::atan2, std::cos, std::sin;
    const Matrix3<Scalar>& A_i = view.motion[i].A;
    const Vector3<Scalar> u_j = view.motion[j].A * u_bar_j;
    const Scalar y = u_j.dot(A_i * v_bar_i), x = u_j.dot(A_i * u_bar_i), c = cos(tracked_angle),
                 s = sin(tracked_angle);
    return tracked_angle + atan2(Scalar(y * c - x * s), Scalar(x * c + y * s));
  }
  /// theta' = z . (omega_j - omega_i).
  Scalar angle_rate(const EffectView<Scalar>& view) const {
    const BodyMotion<Scalar>&bi = view.motion[i], &bj = view.motion[j];
    return axis(view).dot(bj.A * bj.omega_bar - bi.A * bi.omega_bar);
  }
  /// Of theta: what a torque of 1 does to i and to j.
  std::pair<Wrench<Scalar>, Wrench<Scalar>> gradient(const EffectView<Scalar>& view) const {
    const Vector3<Scalar> z = axis(view);
    return {{Vector3<Scalar>::Zero(), -(view.motion[i].A.transpose() * z)},
            {Vector3<Scalar>::Zero(), view.motion[j].A.transpose() * z}};
  }

 private:
  Vector3<Scalar> axis(const EffectView<Scalar>& view) const { return view.motion[i].A * z_bar_i; }
  Scalar torque_on_j(const EffectView<Scalar>& view) const {
    return -(stiffness * (angle(view) - free_angle) + damping * angle_rate(view) + actuator(view.t).f);
  }
};

static_assert(Effect<TorsionalSpringDamper<double>, double>);

}  // namespace trivium
