#pragma once
/// A spring, damper and actuator along the line between two body-fixed points: tension k (l - l0) + c l' +
/// h(t). Haug (1989), translational spring-damper-actuator.

#include <cmath>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "bodies/numbers/lanewise.hpp"
#include "bodies/numbers/time_function.hpp"
#include "bodies/point_offset.hpp"
#include "effects/effect.hpp"

namespace trivium {

template <class Scalar>
struct SpringDamper {
  std::string name;
  int i = 0, j = 0;
  Vector3<Scalar> s_bar_i, s_bar_j;                 ///< its ends [m, body frames]
  Scalar stiffness{0}, damping{0}, free_length{0};  ///< k [N/m], c [N s/m], l0 [m]
  TimeFunction actuator;                            ///< h [N]

  /// use(part...) for every part of one effect or of several side by side.
  template <class Use, class... Part>
  static void show_parts(const Use& use, Part&... p) {
    use(p.i...);
    use(p.j...);
    use(p.s_bar_i...);
    use(p.s_bar_j...);
    use(p.stiffness...);
    use(p.damping...);
    use(p.free_length...);
    use(p.actuator...);
  }

  void apply(const EffectView<Scalar>& view, std::span<Wrench<Scalar>> wrenches) const {
    const Line line = measure(view);
    const Vector3<Scalar> pull = tension(line, view.t) * line.direction;  // on i, towards j
    wrenches[i].add_force(pull, view.motion[i].A, s_bar_i);
    wrenches[j].add_force(-pull, view.motion[j].A, s_bar_j);
  }
  Scalar power(const EffectView<Scalar>& view) const {
    const Line line = measure(view);
    return -tension(line, view.t) * line.length_rate;
  }
  /// That of the damper and the actuator.
  Scalar nonconservative_power(const EffectView<Scalar>& view) const {
    const Line line = measure(view);
    return -(damping * line.length_rate + actuator(view.t).f) * line.length_rate;
  }
  void append_kinks(std::vector<double>& times) const { actuator.append_kinks(times); }
  /// Zero damping and no actuator.
  bool is_conservative() const { return all(damping == Scalar(0)) && actuator == TimeFunction(0); }
  /// k (l - l0)^2 / 2.
  Scalar potential_energy(const EffectView<Scalar>& view) const {
    const Scalar stretch = measure(view).length - free_length;
    return stiffness * stretch * stretch / 2;
  }

  /// Of its length: what a tension of -1 does to i and to j.
  std::pair<Wrench<Scalar>, Wrench<Scalar>> gradient(const EffectView<Scalar>& view) const {
    const Vector3<Scalar> push = measure(view).direction;
    std::pair<Wrench<Scalar>, Wrench<Scalar>> on;
    on.first.add_force(-push, view.motion[i].A, s_bar_i);
    on.second.add_force(push, view.motion[j].A, s_bar_j);
    return on;
  }

  /// The parts of its tension, each pulling for itself: add(body, |F|, |n_bar|).
  template <class Add>
  void add_load_bounds(const EffectView<Scalar>& view, const Add& add) const {
    using std::abs;
    const Line line = measure(view);
    if (line.length == Scalar(0)) return;  // no direction, and no force
    const Scalar pull = stiffness * (line.length + abs(free_length)) + abs(damping * line.length_rate) +
                        abs(actuator(view.t).f);
    const auto load = [&](int body, const Vector3<Scalar>& s_bar) {
      const Vector3<Scalar> arm = s_bar.cross(view.motion[body].A.transpose() * line.direction);
      add(body, Vector3<Scalar>(pull * line.direction.cwiseAbs()), Vector3<Scalar>(pull * arm.cwiseAbs()));
    };
    load(i, s_bar_i);
    load(j, s_bar_j);
  }

 private:
  struct Line {
    Scalar length, length_rate;
    Vector3<Scalar> direction;  ///< from i to j, unit
  };

  Line measure(const EffectView<Scalar>& view) const {
    const BodyMotion<Scalar>&bi = view.motion[i], &bj = view.motion[j];
    const Vector3<Scalar> d = point_offset(bi, s_bar_i, bj, s_bar_j);
    const Scalar length = d.norm();
    if (length == Scalar(0)) return at_zero_length(view.t);
    const Vector3<Scalar> direction = d / length;
    return {length, direction.dot(point_offset_rate(bi, s_bar_i, bj, s_bar_j)), direction};
  }
  /// Where its ends meet, a spring with nothing but stiffness pulls with zero force; any other has no
  /// direction.
  Line at_zero_length(const Scalar& t) const {
    if (stiffness * free_length != Scalar(0) || damping != Scalar(0) || actuator(t).f != Scalar(0))
      throw ModelError(
          fmt::format("spring_damper \"{}\": its two ends coincide at t = {}, so its force has no direction; "
                      "move an end, or "
                      "give it free_length 0, damping 0 and no actuator",
                      name, static_cast<double>(t)));
    return {Scalar(0), Scalar(0), Vector3<Scalar>::Zero()};
  }
  Scalar tension(const Line& line, const Scalar& t) const {
    return stiffness * (line.length - free_length) + damping * line.length_rate + actuator(t).f;
  }
};

static_assert(Effect<SpringDamper<double>, double>);

}  // namespace trivium
