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

/// What a function of time demands, on the way to the end of a reach.
struct Demand {
  /// Until it comes to the end for the first time [s]; nothing if it does not. A function that turns back
  /// before counts if it uses 99 % of the way: `farther` has errors.
  std::optional<double> time;
  double value = 0, at = 0;  ///< the farthest that it demands, and when
  bool is_beyond = false;    ///< the end, by more than these errors
};

/// The demand of f after t [s], where a reach ends `farther` from the value at t. The time is looked for
/// within `horizon`, and the farthest value within twice as much.
inline Demand demand_of(const TimeFunction& f, double t, double farther, double horizon) {
  constexpr double error = 0.01;  // of `farther`
  const double now = f(t).f, rounding = 1e-12 * std::abs(now * farther), whole = farther * farther;
  Demand demand{{}, now, t, false};
  double used = 0;
  const auto look = [&](double dt) {
    const double value = f(t + dt).f, way = (value - now) * farther;
    if (!demand.time && dt <= horizon && way >= (1 - error) * whole - rounding) demand.time = dt;
    if (way > used) {
      used = way;
      demand.value = value;
      demand.at = t + dt;
    }
  };
  look(0);
  // each time 5 % farther than the last, so that a maximum is met to 1e-3 of its distance
  for (double dt = 1e-9 * horizon; dt < horizon; dt *= 1.05) look(dt);
  for (const double more : {1.0, 1.25, 1.5, 1.75, 2.0}) look(more * horizon);
  demand.is_beyond = used > (1 + error) * whole + rounding;
  return demand;
}

/// A driver that comes to the end of its reach.
struct LostGrip {
  int row = -1;  ///< -1: none does
  RowReach reach;
  Demand demand;
  double share = 0;  ///< of its grip at the start [-]
};

/// The driver that comes to the end of its reach first, if any goes beyond it, within a few steps of length
/// `step` [s] after `now`, as steps that come close to it may fail, or within a hundredth of the time since
/// the start. `drivers` are rows.
template <class Types>
LostGrip first_lost_grip(const Mechanism<double, Types>& mechanism, const std::vector<int>& drivers,
                         const MechanismState<double>& start, const MechanismState<double>& now,
                         double step) {
  // of the grip at the start; above `lost` `farther` says little, unless it is a small part of the value, as
  // where the start is close to the end
  constexpr double lost = 0.5, at_end = 1e-3, small = 0.2, few_steps = 4;
  const TangentSystem before = tangent_system(mechanism, start), after = tangent_system(mechanism, now);
  const double horizon = std::max(few_steps * step, (now.t - start.t) / 100);
  LostGrip first;
  first.demand.time = horizon;
  for (const int row : drivers) {
    const double at_start = free_motion(before, row).gradient;
    if (!(at_start > 0)) continue;  // redundant or contradicted from the start: there is no grip to lose
    const RowReach reach = reach_of(mechanism, now, after, row);
    if (!std::isfinite(reach.farther)) continue;
    const TimeFunction& f = function_of(mechanism.rows[row]);
    const Jet<double> here = f(now.t);
    const bool has_lost = reach.grip < lost * at_start;
    const bool is_close = std::abs(reach.farther) < small * std::abs(here.f) && here.f_t * reach.farther >= 0;
    if (!(has_lost || is_close)) continue;
    Demand demand = demand_of(f, now.t, reach.farther, horizon);
    // with so little grip the driver is at the end, also if its function has just turned back
    if (reach.grip < at_end * at_start) demand.time = 0;
    if (!demand.time || first.demand.is_beyond > demand.is_beyond) continue;
    if (first.demand.is_beyond == demand.is_beyond && *demand.time > *first.demand.time) continue;
    first = {row, reach, demand, reach.grip / at_start};
  }
  return first;
}

/// A message about first_lost_grip; empty if no driver loses its grip.
template <class Types>
std::string lost_grip(const Mechanism<double, Types>& mechanism, const std::vector<int>& drivers,
                      const MechanismState<double>& start, const MechanismState<double>& now, double step) {
  if (drivers.empty()) return {};
  const auto [row, reach, demand, share] = first_lost_grip(mechanism, drivers, start, now, step);
  if (row < 0) return {};
  const double value = function_of(mechanism.rows[row])(now.t).f;
  double end = value + reach.farther;
  if (std::abs(end) < 1e-12 * std::abs(value)) end = 0;  // rounding
  const char* up_to = reach.farther >= 0 ? "up to" : "down to";
  int digits = 6;  // or as many as show that the demand is beyond the end
  while (digits < 17 && fmt::format("{:.{}g}", demand.value, digits) == fmt::format("{:.{}g}", end, digits))
    ++digits;
  const std::string trouble =
      demand.is_beyond
          ? fmt::format(
                "demands f = {:.{}g} at t = {:.9g}, but from its value {:.{}g} at t = {:.9g} the other "
                "rows leave only values {} about {:.{}g} within reach",
                demand.value, digits, demand.at, value, digits, now.t, up_to, end, digits)
          : fmt::format(
                "comes to a dead point: its value is {:.6g} at t = {:.9g}, where the other rows leave "
                "values {} about {:.6g} within reach",
                value, now.t, up_to, end);
  return fmt::format(
      "driver \"{}\" {}, and the part of its gradient that they leave free is {:.1e} of that at the "
      "start. The rank of the rows falls by 1 there. Give it another function of time, or drive another "
      "joint",
      mechanism.row_names[row], trouble, share);
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
