#pragma once
/// Why a driver may have ended a motion. At a dead point, and where a driver demands a position that the
/// mechanism cannot reach, the other rows leave no motion that would move the driver: its grip, the part of
/// its gradient that they leave free (free_gradient), falls to 0.
///
/// A driver is a row x . y = f(t). Near the farthest value F that x . y can reach, F - f is proportional to
/// the square of the grip. So f and the grips at two states give F.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "constraints/constraint_row.hpp"
#include "formulations/analysis/row_analysis.hpp"
#include "formulations/analysis/tangent_system.hpp"
#include "mechanism/mechanism.hpp"

namespace trivium {

/// A message about the driver that has lost most of its grip since the start; empty if none has less than a
/// tenth of it. `drivers` are rows. Mechanisms of more than 600 unknowns are not looked at, since the dense
/// analysis would take seconds.
template <class Types>
std::string lost_grip(const Mechanism<double, Types>& mechanism, const std::vector<int>& drivers,
                      const MechanismState<double>& start, const MechanismState<double>& now) {
  constexpr double lost = 0.1;  // at failures by a dead point the grip has fallen by decades
  constexpr int most_unknowns = 600;
  if (drivers.empty() || 6 * mechanism.nb() + mechanism.nc() > most_unknowns) return {};
  const TangentSystem before = tangent_system(mechanism, start), after = tangent_system(mechanism, now);
  double least = lost;
  int worst = -1;
  for (const int row : drivers) {
    const double at_start = free_gradient(before, row), share = free_gradient(after, row) / at_start;
    if (at_start > 0 && share < least) {
      least = share;
      worst = row;
    }
  }
  if (worst < 0) return {};
  const TimeFunction& function = function_of(mechanism.rows[worst]);
  const Jet<double> f = function(now.t);
  const double moved = f.f - function(start.t).f,
               farthest = f.f + moved * least * least / (1 - least * least);
  return fmt::format(
      "driver \"{}\" demands f = {:.6g} at t = {}, changing by {:.4g} per second, but the other rows leave "
      "values {} about {:.6g} within reach: the part of its gradient that the other rows leave free has "
      "fallen to {:.1e} of that at the start. It comes to a dead point or to the end of its reach, where the "
      "rank of the rows falls by 1. Give it another function of time, or drive another joint",
      mechanism.row_names[worst], f.f, now.t, f.f_t, moved > 0 ? "up to" : "down to", farthest, least);
}

}  // namespace trivium
