#pragma once
/// Why a step may have failed: at a state that it has reached, messages about a load, a chart, a driver, the
/// rows and the place of a mechanism. The solvers of single steps report numbers; only the model knows names.

#include <fmt/format.h>

#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "formulations/near_singular_chart.hpp"
#include "simulation/system/driver_grip.hpp"
#include "simulation/system/far_from_origin.hpp"
#include "simulation/system/loads_by_effect.hpp"
#include "simulation/system/trouble_of_rows.hpp"

namespace trivium {

/// Where a motion began: with this state later ones are compared.
template <class S>
struct StartOfMotion {
  MechanismState<S> state;
  std::vector<BodyMotion<S>> motion;  ///< the same, as effects see it
};

/// A message about an effect whose load is not finite, or above 1e100, the largest number of a scene; empty
/// if there is none.
template <class S, class List>
std::string excessive_load(const Effects<S, List>& effects, const EffectView<S>& view) {
  const std::string effect = effect_above(effects, view, S(1e100));
  return effect.empty()
             ? effect
             : fmt::format(
                   "the load of {} is not finite there or exceeds 1e100 N or N m; give it smaller numbers or "
                   "another function of time",
                   effect);
}

/// A message if a load, a singular chart, a driver, a singular position, contradicting drivers or a far
/// position may have made a step from a state fail; empty if not. The state is given in coordinates, for
/// effects, and as `now`; `drivers` are rows. `step` [s] is the length of the given step, or 0. Given steps
/// that are too long make a motion diverge: they are the reason of a load or a distance that is not too large
/// in the state of the start.
template <Formulation F, class S = typename F::Scalar>
std::string diagnose(const MechanismOf<F>& mechanism, const std::vector<int>& drivers,
                     const StartOfMotion<S>& start, const std::vector<BodyState<F>>& state,
                     const EffectView<S>& view, const MechanismState<S>& now, const S& step) {
  const bool may_diverge = step != S(0);
  std::string message;
  if (!may_diverge || !excessive_load(mechanism.effects, {mechanism.bodies, start.motion, view.t}).empty())
    message = excessive_load(mechanism.effects, view);
  if (message.empty()) message = near_singular_chart<F>(mechanism, state, view.t, S(reframing_distance));
  if constexpr (std::is_same_v<S, double>) {
    constexpr int most_unknowns = 1500;  // the dense analysis of more would take many seconds
    if (6 * mechanism.nb() + mechanism.nc() > most_unknowns) return message;
    if (message.empty()) message = lost_grip(mechanism, drivers, start.state, now, step);
    if (message.empty()) message = trouble_of_rows(mechanism, drivers, start.state, now);
    if (message.empty()) message = poor_grip(mechanism, drivers, now);
    if (message.empty() && (!may_diverge || !far_from_origin(mechanism, start.state).empty()))
      message = far_from_origin(mechanism, now);
  }
  return message;
}

/// The body with the largest acceleration of a solution and its largest load, unless the constraints outweigh
/// all loads by far, as a clause for messages; empty if none accelerates, but for rounding of loads that
/// cancel.
template <Formulation F, class S = typename F::Scalar>
std::string most_accelerated(const MechanismOf<F>& mechanism, const AccelerationSolver<F>& solver,
                             const EffectView<S>& view) {
  const auto inertia_force = [&](int b) {
    const auto& body = mechanism.bodies[b];
    return S(body.mass * solver.r_ddot(b).norm() + (body.inertia * solver.omega_bar_dot(b)).norm());
  };
  int fastest = -1;
  S largest(0), inertia_forces(0), loads(0);  // the last two in N and N m
  const std::vector<Wrench<S>> sizes = load_sizes(mechanism.effects, view);
  for (int b = 0; b < mechanism.nb(); ++b) {
    inertia_forces += inertia_force(b);
    loads += sizes[b].F.norm() + sizes[b].n_bar.norm();
    if (const S size = solver.r_ddot(b).norm() + solver.omega_bar_dot(b).norm(); size > largest) {
      largest = size;
      fastest = b;
    }
  }
  if (fastest < 0 || inertia_forces <= 1000 * std::numeric_limits<S>::epsilon() * loads) return {};
  const std::string load = largest_load(mechanism.effects, view, fastest, S(inertia_force(fastest) / 100));
  return fmt::format("body \"{}\" accelerates most there, by {:.1e} m/s^2 and {:.1e} rad/s^2, {}",
                     mechanism.body_names[fastest], static_cast<double>(solver.r_ddot(fastest).norm()),
                     static_cast<double>(solver.omega_bar_dot(fastest).norm()),
                     load.empty() ? "which its constraints demand" : "and is loaded most by " + load);
}

}  // namespace trivium
