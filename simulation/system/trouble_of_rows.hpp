#pragma once
/// Whether dependent rows may have ended a motion: at a singular position, where rows become dependent that
/// are independent elsewhere, and the mechanism can go on in more than one way, or because a driver asks for
/// something else than the rows that it depends on.

#include <string>
#include <vector>

#include "formulations/analysis/tangent_system.hpp"
#include "mechanism/mechanism.hpp"

namespace trivium {

/// A message if the rows at time t are much closer to being dependent than they were before, or if drivers
/// contradict the rows that they depend on; empty if not. `drivers` are rows.
std::string trouble_of_rows(const std::vector<std::string>& row_names, const std::vector<int>& drivers,
                            const TangentSystem& before, const TangentSystem& now, double t);

/// The same for two states of a mechanism.
template <class Types>
std::string trouble_of_rows(const Mechanism<double, Types>& mechanism, const std::vector<int>& drivers,
                            const MechanismState<double>& start, const MechanismState<double>& now) {
  if (mechanism.nc() == 0) return {};
  return trouble_of_rows(mechanism.row_names, drivers, tangent_system(mechanism, start),
                         tangent_system(mechanism, now), now.t);
}

}  // namespace trivium
