#pragma once
/// Whether dependent rows may have ended a motion: at a singular position, where rows become dependent that
/// are independent elsewhere, and the mechanism can go on in more than one way, or because a driver asks for
/// something else than the rows that it depends on.

#include <functional>
#include <string>
#include <vector>

#include "formulations/analysis/tangent_system.hpp"
#include "mechanism/mechanism.hpp"

namespace trivium {

/// The positions that the velocities of a state lead to in the time dt [s]; its time and velocities stay.
MechanismState<double> coasted(MechanismState<double> state, double dt);

/// A message if the rows at time t are much closer to being dependent than they were at the start, or come
/// to be or were so within a fiftieth of the time since then, or if drivers contradict the rows that they
/// depend on; empty if not. `drivers` are rows; `after(dt)`: the rows of coasted positions.
std::string trouble_of_rows(const std::vector<std::string>& row_names, const std::vector<int>& drivers,
                            double start, const TangentSystem& at_start, double t,
                            const std::function<TangentSystem(double)>& after);

/// The same for two states of a mechanism.
template <class Types>
std::string trouble_of_rows(const Mechanism<double, Types>& mechanism, const std::vector<int>& drivers,
                            const MechanismState<double>& start, const MechanismState<double>& now) {
  if (mechanism.nc() == 0) return {};
  return trouble_of_rows(mechanism.row_names, drivers, start.t, tangent_system(mechanism, start), now.t,
                         [&](double dt) { return tangent_system(mechanism, coasted(now, dt)); });
}

}  // namespace trivium
