#pragma once
/// Whether dependent rows may have ended a motion: at a singular position, where rows become dependent that
/// are independent elsewhere, and the mechanism can go on in more than one way, or because a driver asks for
/// something else than the rows that it depends on.

#include <functional>
#include <string>
#include <vector>

#include "bodies/rotations/so3.hpp"
#include "formulations/analysis/tangent_system.hpp"
#include "mechanism/mechanism.hpp"

namespace trivium {

/// A message if the rows at time t are much closer to being dependent than they were at the start, or come
/// to be within a fiftieth of the time since then, or if drivers contradict the rows that they depend on;
/// empty if not. `drivers` are rows; `after(dt)`: the rows a time dt after t, as the velocities are.
std::string trouble_of_rows(const std::vector<std::string>& row_names, const std::vector<int>& drivers,
                            double start, const TangentSystem& at_start, double t,
                            const std::function<TangentSystem(double)>& after);

/// The same for two states of a mechanism.
template <class Types>
std::string trouble_of_rows(const Mechanism<double, Types>& mechanism, const std::vector<int>& drivers,
                            const MechanismState<double>& start, const MechanismState<double>& now) {
  if (mechanism.nc() == 0) return {};
  return trouble_of_rows(mechanism.row_names, drivers, start.t, tangent_system(mechanism, start), now.t,
                         [&](double dt) {
                           MechanismState<double> later = now;
                           for (std::size_t b = 0; b < now.pose.size(); ++b) {
                             later.pose[b].r += dt * now.twist[b].r_dot;
                             const Vector3<double> half = dt / 2 * now.twist[b].omega_bar;
                             const Vector4<double> turn(1, half[0], half[1], half[2]);
                             later.pose[b].p = multiply_parameters(now.pose[b].p, turn.normalized().eval());
                           }
                           return tangent_system(mechanism, later);
                         });
}

}  // namespace trivium
