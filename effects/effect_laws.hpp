#pragma once
/// The laws of an effect, a test for new effects. The concept Effect checks which members exist;
/// `broken_laws` checks in a given motion that they are consistent: wrenches, power and stored energy with
/// each other, and `keys` and the optional members with the wrenches. The bounds are safety factors of 1e4 or
/// 1e6 on the rounding error: far above the rounding of an effect that is right, far below the relative error
/// of about 1 of an effect that is wrong.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/broken_law.hpp"
#include "bodies/rotations/so3.hpp"
#include "effects/effect.hpp"

namespace trivium {

namespace detail {

/// The law of a Spring: damping 1 adds the wrenches -x' gradient, with x' the power of the gradient.
template <class E, class S, class Equal>
void spring_laws(E effect, const EffectView<S>& view, const Equal& equal) {
  static_assert(Spring<E, S>);
  std::vector<Wrench<S>> with(view.motion.size()), without = with;
  effect.damping = S(0);
  effect.apply(view, without);
  effect.damping = S(1);
  effect.apply(view, with);
  const auto [i, j] = effect.bodies();
  const auto [on_i, on_j] = effect.gradient(view);
  const auto along = [&](const Wrench<S>& on, int b) {
    return S(on.F.dot(view.motion[b].r_dot) + on.n_bar.dot(view.motion[b].omega_bar));
  };
  const S rate = along(on_i, i) + along(on_j, j), scale = effect.tension_scale(view);
  equal("tension_scale is not negative", S(scale >= S(0) ? 0 : 1), S(0), S(0), 0);
  const auto compare = [&](int b, const Wrench<S>& on) {
    const S off = (with[b].F - without[b].F + rate * on.F).norm() +
                  (with[b].n_bar - without[b].n_bar + rate * on.n_bar).norm();
    const S size = with[b].F.norm() + without[b].F.norm() + with[b].n_bar.norm() + without[b].n_bar.norm();
    // 1e6: the damping force is a difference of wrenches, whose other terms may be larger
    equal("the damping force acts along the gradient", off, S(0), size,
          1e6 * static_cast<double>(std::numeric_limits<S>::epsilon()));
  };
  compare(i, on_i);
  compare(j, on_j);
}

}  // namespace detail

/// The laws that `effect` breaks in this motion (the ground's last) at time t [s]; empty if none. The effect
/// must be defined at this state, e.g. the ends of a spring must not coincide.
template <class E, class S>
std::vector<BrokenLaw> broken_laws(const E& effect, const std::vector<RigidBody<S>>& bodies,
                                   const std::vector<BodyMotion<S>>& motion, const S& t) {
  static_assert(Effect<E, S>);
  using std::abs, std::cbrt;
  std::vector<BrokenLaw> broken;
  const double u = static_cast<double>(std::numeric_limits<S>::epsilon());
  // `u` is the machine epsilon. a = b up to `bound` relative to |a| + |b| + size, with `size` the magnitude
  // of the terms of both
  const auto equal = [&](const char* law, const S& a, const S& b, const S& size, double bound) {
    using std::abs;
    const S off = abs(S(a - b)), all = abs(a) + abs(b) + size;
    const double share = static_cast<double>(all > S(0) ? S(off / all) : off);
    if (!(share <= bound)) broken.push_back({law, share, bound});
  };
  const EffectView<S> view{bodies, motion, t};
  std::vector<Wrench<S>> wrenches(motion.size()), twice;
  effect.apply(view, wrenches);
  S of_wrenches(0), size(0);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    of_wrenches += wrenches[b].F.dot(motion[b].r_dot) + wrenches[b].n_bar.dot(motion[b].omega_bar);
    size +=
        wrenches[b].F.norm() * motion[b].r_dot.norm() + wrenches[b].n_bar.norm() * motion[b].omega_bar.norm();
  }
  equal("power is the power of the wrenches from apply", effect.power(view), of_wrenches, size, 1e4 * u);
  twice = wrenches;
  effect.apply(view, twice);
  S added(0), once(0);
  for (std::size_t b = 0; b < wrenches.size(); ++b) {
    added += (twice[b].F - wrenches[b].F).norm() + (twice[b].n_bar - wrenches[b].n_bar).norm();
    once += wrenches[b].F.norm() + wrenches[b].n_bar.norm();
  }
  equal("apply adds to the given wrenches", added, once, S(0), 1e4 * u);
  const auto acts_the_same = [&](const char* law, const E& other, const EffectView<S>& seen) {
    std::vector<Wrench<S>> of_other(motion.size());
    other.apply(seen, of_other);
    for (std::size_t b = 0; b < wrenches.size(); ++b)
      equal(law, (of_other[b].F - wrenches[b].F).norm() + (of_other[b].n_bar - wrenches[b].n_bar).norm(),
            S(0), once, 1e4 * u);
  };
  E copy;
  show_effect_parts([](const auto& from, auto& to) { to = from; }, effect, copy);
  acts_the_same("show_effect_parts shows every part", copy, view);
  const auto same_energy = [&](const S& of_all, const S& of_copied) {
    equal("show_effect_parts shows every part", of_copied, of_all, size, 1e4 * u);
  };
  same_energy(effect.power(view), copy.power(view));
  same_energy(effect.potential_energy(view), copy.potential_energy(view));
  same_energy(effect.nonconservative_power(view), copy.nonconservative_power(view));
  if constexpr (requires { copy.follow(view); }) {
    copy = effect;
    copy.follow(view);
    acts_the_same("follow does not change the wrenches", copy, view);
  }
  // the functions of time among the keys may have kinks, which append_kinks must contain
  std::vector<double> shown_kinks, kinks;
  show_effect_parts(
      [&](const auto& part) {
        if constexpr (requires { part.append_kinks(shown_kinks); }) part.append_kinks(shown_kinks);
        if constexpr (requires { part[0].append_kinks(shown_kinks); })
          for (const auto& one : part) one.append_kinks(shown_kinks);
      },
      effect);
  if constexpr (requires { effect.append_kinks(kinks); }) effect.append_kinks(kinks);
  std::sort(shown_kinks.begin(), shown_kinks.end());
  std::sort(kinks.begin(), kinks.end());
  if (!std::includes(kinks.begin(), kinks.end(), shown_kinks.begin(), shown_kinks.end()))
    broken.push_back({"append_kinks names the kinks of the functions of time", 1, 0});
  // Stored energy after r and A have moved for the time `by` with constant r' and omega_bar. With h =
  // cbrt(epsilon), where epsilon is the local `u`, the truncation error of the central difference, of order
  // h^2, and its rounding error, epsilon / h, are equal.
  const S h(cbrt(u));
  const auto stored = [&](const S& by) {
    std::vector<BodyMotion<S>> moved = motion;
    for (BodyMotion<S>& body : moved) {
      body.r += by * body.r_dot;
      body.A = (body.A * rotation_matrix(exponential_parameters<S>(by * body.omega_bar))).eval();
    }
    return S(effect.potential_energy(EffectView<S>{bodies, moved, t}));
  };
  if constexpr (requires { effect.gradient(view); }) detail::spring_laws(effect, view, equal);
  if constexpr (requires { E::sees_motion; })
    if (!E::sees_motion) {
      std::vector<BodyMotion<S>> elsewhere = motion;
      const Matrix3<S> turn = rotation_matrix(exponential_parameters<S>(Vector3<S>(S(0.3), S(-0.7), S(0.4))));
      for (std::size_t b = 0; b < bodies.size(); ++b) {
        elsewhere[b].r += Vector3<S>::Ones();
        elsewhere[b].r_dot += Vector3<S>::Ones();
        elsewhere[b].A = (turn * elsewhere[b].A).eval();
        elsewhere[b].omega_bar += Vector3<S>::Ones();
      }
      acts_the_same("sees_motion is false: the wrenches do not depend on the motion", effect,
                    EffectView<S>{bodies, elsewhere, t});
    }
  if constexpr (requires { effect.longest_step(view); })
    equal("longest_step is positive", S(effect.longest_step(view) > S(0) ? 0 : 1), S(0), S(0), 0);
  const auto no_bound = [](int, const Vector3<S>&, const Vector3<S>&) {};
  if constexpr (requires { effect.add_load_bounds(view, no_bound); }) {
    std::vector<Vector3<S>> F(motion.size(), Vector3<S>::Zero()), n_bar = F;
    effect.add_load_bounds(view, [&](int body, const Vector3<S>& on_F, const Vector3<S>& on_n_bar) {
      F[body] += on_F;
      n_bar[body] += on_n_bar;
    });
    for (std::size_t b = 0; b < motion.size(); ++b) {
      const Vector3<S> room_F = F[b] - wrenches[b].F.cwiseAbs(),
                       room_n = n_bar[b] - wrenches[b].n_bar.cwiseAbs();
      const S least = -S(1e4 * u) * once;
      const bool holds = (room_F.array() >= least).all() && (room_n.array() >= least).all();
      equal("add_load_bounds: no wrench exceeds its bound", S(holds ? 0 : 1), S(0), S(0), 0);
    }
  }
  const S behind = stored(-h), ahead = stored(h);
  equal("power minus nonconservative_power is the decrease of potential_energy",
        S(effect.power(view) - effect.nonconservative_power(view)), S((behind - ahead) / (2 * h)),
        S(size + abs(behind) + abs(ahead)), 1e4 * cbrt(u * u));
  if (effect.is_conservative())
    equal("is_conservative: nonconservative_power is zero", effect.nonconservative_power(view), S(0), size,
          1e4 * u);
  return broken;
}

}  // namespace trivium
