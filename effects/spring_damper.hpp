#pragma once
/// A spring, damper and actuator along the line between two body-fixed points (Haug 1989, translational
/// spring-damper-actuator). The tension f, with l the distance of the points, pulls the points towards each
/// other if it is positive:
///
///     f = k (l - l0) + c l' + h(t) [N],   force on i: f d_ij / l,   force on j: -f d_ij / l

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "bodies/numbers/lanewise.hpp"
#include "bodies/numbers/time_function.hpp"
#include "bodies/point_offset.hpp"
#include "effects/effect.hpp"
#include "effects/effect_parts.hpp"

namespace trivium {

/// A spring, damper and actuator between two points. Where the end points coincide (l = 0), the force has no
/// direction. Functions that need l then throw a ModelError, unless k l0, c and h(t) are all 0, so that the
/// force is 0 as well.
template <class Scalar>
struct SpringDamper {
  static constexpr std::string_view type = "spring_damper";

  std::string name;
  BodyPoint<Scalar> i, j;                           ///< end points on bodies i and j
  Scalar stiffness{0}, damping{0}, free_length{0};  ///< k [N/m], c [N s/m], l0 [m]
  TimeFunction actuator;                            ///< h [N]
  bool operator==(const SpringDamper&) const = default;

  static void keys(auto&& show, auto&... e) {
    show.point("i", e.i...);
    show.point("j", e.j...);
    show.may("stiffness", e.stiffness...);
    show.may("damping", e.damping...);
    show.may("free_length", e.free_length...);
    show.may("actuator", e.actuator...);
  }

  void apply(const EffectView<Scalar>& view, std::span<Wrench<Scalar>> wrenches) const {
    const Line line = measure(view);
    const Vector3<Scalar> pull = tension(line, view.t) * line.direction;  // on i, towards j
    wrenches[i.body].add_force(pull, view.motion[i.body].A, i.s_bar);
    wrenches[j.body].add_force(-pull, view.motion[j.body].A, j.s_bar);
  }
  Scalar power(const EffectView<Scalar>& view) const {
    const Line line = measure(view);
    return -tension(line, view.t) * line.length_rate;
  }
  /// The power of the damper and the actuator, -(c l' + h) l' [W].
  Scalar nonconservative_power(const EffectView<Scalar>& view) const {
    const Line line = measure(view);
    return -(damping * line.length_rate + actuator(view.t).f) * line.length_rate;
  }
  void append_kinks(std::vector<double>& times) const { actuator.append_kinks(times); }
  /// Whether damping and actuator are 0.
  bool is_conservative() const { return all(damping == Scalar(0)) && actuator == TimeFunction(0); }
  /// k (l - l0)^2 / 2 [J].
  Scalar potential_energy(const EffectView<Scalar>& view) const {
    const Scalar stretch = measure(view).length - free_length;
    return stiffness * stretch * stretch / 2;
  }

  std::pair<int, int> bodies() const { return {i.body, j.body}; }
  /// The gradient of l: the wrenches on bodies i and j of a tension of -1 N. Their power is l'.
  std::pair<Wrench<Scalar>, Wrench<Scalar>> gradient(const EffectView<Scalar>& view) const {
    const Vector3<Scalar> push = measure(view).direction;
    std::pair<Wrench<Scalar>, Wrench<Scalar>> on;
    on.first.add_force(-push, view.motion[i.body].A, i.s_bar);
    on.second.add_force(push, view.motion[j.body].A, j.s_bar);
    return on;
  }

  /// |k| times the sum of the lengths whose difference is l - l0, plus |c| times the sum of the speeds whose
  /// difference is l' [N]. The distance of each centre from the origin is one of these lengths, since the
  /// rounding error of a position is an error of l.
  Scalar tension_scale(const EffectView<Scalar>& view) const {
    using std::abs;
    const BodyMotion<Scalar>&bi = view.motion[i.body], &bj = view.motion[j.body];
    const Scalar s_i = i.s_bar.norm(), s_j = j.s_bar.norm();
    return abs(stiffness) * (bi.r.norm() + s_i + bj.r.norm() + s_j + abs(free_length)) +
           abs(damping) *
               (bi.r_dot.norm() + bi.omega_bar.norm() * s_i + bj.r_dot.norm() + bj.omega_bar.norm() * s_j);
  }

  /// Bounds of the wrenches, for estimates of rounding errors. Calls add(body, F, n_bar) for both ends, where
  /// F [N, global] and n_bar [N m, body frame] are the magnitudes, component by component, of the force and
  /// the moment of the tension |k| (l + |l0|) + |c l'| + |h(t)|. All terms of this tension are positive, so
  /// that none cancel.
  template <class Add>
  void add_load_bounds(const EffectView<Scalar>& view, const Add& add) const {
    using std::abs;
    const Line line = measure(view);
    if (line.length == Scalar(0)) return;  // the force is zero (at_zero_length)
    const Scalar pull = abs(stiffness) * (line.length + abs(free_length)) + abs(damping * line.length_rate) +
                        abs(actuator(view.t).f);
    const auto load = [&](const BodyPoint<Scalar>& end) {
      const Vector3<Scalar> arm = end.s_bar.cross(view.motion[end.body].A.transpose() * line.direction);
      add(end.body, Vector3<Scalar>(pull * line.direction.cwiseAbs()),
          Vector3<Scalar>(pull * arm.cwiseAbs()));
    };
    load(i);
    load(j);
  }

 private:
  struct Line {
    Scalar length, length_rate;
    Vector3<Scalar> direction;  ///< from i to j, unit
  };

  Line measure(const EffectView<Scalar>& view) const {
    const BodyMotion<Scalar>&bi = view.motion[i.body], &bj = view.motion[j.body];
    const Vector3<Scalar> d = point_offset(bi, i.s_bar, bj, j.s_bar);
    const Scalar length = d.norm();
    if (length == Scalar(0)) return at_zero_length(view.t);
    const Vector3<Scalar> direction = d / length;
    return {length, direction.dot(point_offset_rate(bi, i.s_bar, bj, j.s_bar)), direction};
  }
  /// The line of end points that coincide, with direction 0, if k l0, c and h(t) are 0, so that the tension
  /// is 0. Otherwise throws a ModelError, because the force has no direction.
  Line at_zero_length(const Scalar& t) const {
    if (stiffness * free_length != Scalar(0) || damping != Scalar(0) || actuator(t).f != Scalar(0))
      throw ModelError({fmt::format("spring_damper \"{}\"", name), static_cast<double>(t)},
                       "the two ends coincide, so the force has no direction; move an end, or set "
                       "free_length 0, damping 0 and no actuator");
    return {Scalar(0), Scalar(0), Vector3<Scalar>::Zero()};
  }
  Scalar tension(const Line& line, const Scalar& t) const {
    return stiffness * (line.length - free_length) + damping * line.length_rate + actuator(t).f;
  }
};

static_assert(Effect<SpringDamper<double>, double>);

}  // namespace trivium
