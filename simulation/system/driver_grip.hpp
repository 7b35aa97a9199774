#pragma once
/// Why a driver may have ended a motion. At a dead point, and where a driver demands a position that the
/// mechanism cannot reach, the other rows leave no motion that would move the driver: its grip, the part of
/// its gradient that they leave free (free_motion), falls to 0.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "constraints/constraint_row.hpp"
#include "formulations/analysis/row_analysis.hpp"
#include "formulations/analysis/tangent_system.hpp"
#include "mechanism/mechanism.hpp"

namespace trivium {

/// How far the value of a row can go from a state while the other rows hold.
struct RowReach {
  double grip = 0;     ///< size of the free gradient [unit of the row per m]
  double farther = 0;  ///< from the present value to the extremum that is nearest [unit of the row]
};

/// The reach of a row x . y = f(t) from a state, with its tangent system `here`. Along its free motion the
/// row has the slope s, its grip, and a curvature c, so that its extremum is s^2 / (-2 c) away. Exact near
/// the extremum.
template <class Types>
RowReach reach_of(const Mechanism<double, Types>& mechanism, MechanismState<double> state,
                  const TangentSystem& here, int row) {
  const FreeMotion motion = free_motion(here, row);
  if (!(motion.gradient > 0)) return {};
  const auto gamma_of = [&](double velocities) {
    for (int b = 0; b < mechanism.nb(); ++b)
      state.twist[b] = {velocities * motion.q_dot.template segment<3>(6 * b),
                        velocities * motion.q_dot.template segment<3>(6 * b + 3)};
    return tangent_system(mechanism, state).gamma;
  };
  // without what is constant or linear in the velocities, such as f'' of the functions of time
  const VectorX<double> gamma = (gamma_of(1) + gamma_of(-1)) / 2 - gamma_of(0);
  const double curvature = free_curvature(here, row, gamma);
  return {motion.gradient, -motion.gradient * motion.gradient / (2 * curvature)};
}

/// When f(t) comes to the end of a reach, `farther` from its present value, for the first time within
/// `horizon` after t [s]; nothing if it does not. A function that turns back before counts as coming to the
/// end if it uses 99 % of the way: `farther` has errors.
inline std::optional<double> time_to(const TimeFunction& f, double t, double farther, double horizon) {
  const double now = f(t).f;
  const auto is_used = [&](double value) {
    return (value - now) * farther >= 0.99 * farther * farther - 1e-12 * std::abs(now * farther);
  };
  if (is_used(now)) return 0;
  // each time 5 % farther than the last, so that a maximum is met to 1e-3 of its distance
  for (double dt = 1e-9 * horizon; dt < 1.05 * horizon; dt *= 1.05)
    if (is_used(f(t + std::min(dt, horizon)).f)) return std::min(dt, horizon);
  return {};
}

/// A message about the driver that comes to the end of its reach first, within two steps of length `step` [s]
/// after `now`, as one that ends close to it may fail, or within a hundredth of the time since the start;
/// empty if none does. `drivers` are rows.
template <class Types>
std::string lost_grip(const Mechanism<double, Types>& mechanism, const std::vector<int>& drivers,
                      const MechanismState<double>& start, const MechanismState<double>& now, double step) {
  // of the grip at the start; above `lost` `farther` says little, unless it is a small part of the value, as
  // where the start is close to the end
  constexpr double lost = 0.5, at_end = 1e-3, small = 0.05;
  if (drivers.empty()) return {};
  const TangentSystem before = tangent_system(mechanism, start), after = tangent_system(mechanism, now);
  double first = std::max(2 * step, (now.t - start.t) / 100), share = 0;
  int worst = -1;
  RowReach reach;
  for (const int row : drivers) {
    const double at_start = free_motion(before, row).gradient;
    if (!(at_start > 0)) continue;  // redundant or contradicted from the start: there is no grip to lose
    const RowReach of_row = reach_of(mechanism, now, after, row);
    const TimeFunction& f = function_of(mechanism.rows[row]);
    const bool is_close = std::abs(of_row.farther) < small * std::abs(f(now.t).f);
    if (!(of_row.grip < lost * at_start || is_close) || !std::isfinite(of_row.farther)) continue;
    // with so little grip the driver is at the end, also if its function has just turned back
    const auto time =
        of_row.grip < at_end * at_start ? std::optional<double>(0) : time_to(f, now.t, of_row.farther, first);
    if (!time) continue;
    first = *time;
    worst = row;
    reach = of_row;
    share = of_row.grip / at_start;
  }
  if (worst < 0) return {};
  const Jet<double> f = function_of(mechanism.rows[worst])(now.t);
  return fmt::format(
      "driver \"{}\" demands f = {:.6g} at t = {}, changing by {:.4g} per second, but the other rows leave "
      "values {} about {:.6g} within reach: the part of its gradient that the other rows leave free has "
      "fallen to {:.1e} of that at the start. It comes to a dead point or to the end of its reach, where the "
      "rank of the rows falls by 1. Give it another function of time, or drive another joint",
      mechanism.row_names[worst], f.f, now.t, f.f_t, reach.farther >= 0 ? "up to" : "down to",
      f.f + reach.farther, share);
}

/// A message about a driver that is within 1e-4 of its value from the end of its reach; empty if none is.
template <class Types>
std::string poor_grip(const Mechanism<double, Types>& mechanism, const std::vector<int>& drivers,
                      const MechanismState<double>& now) {
  if (drivers.empty()) return {};
  const TangentSystem here = tangent_system(mechanism, now);
  for (const int row : drivers) {
    const double value = function_of(mechanism.rows[row])(now.t).f;
    const RowReach reach = reach_of(mechanism, now, here, row);
    if (reach.grip > 0 && std::abs(reach.farther) < 1e-4 * std::abs(value))
      return fmt::format(
          "driver \"{}\" is near the end of its reach, where it loses its grip: what it demands there hardly "
          "changes with the positions. Start farther from this dead point, or drive another joint",
          mechanism.row_names[row]);
  }
  return {};
}

}  // namespace trivium
