#pragma once
/// Displacements between states. The vector y begins with q and v, and ends with the work if the system has
/// one. A displacement d has as many numbers as v. On a Lie group q may have more.

#include <concepts>

#include "integrators/contract/first_order_system.hpp"

namespace trivium::integrators {

///   position_size, velocity_size
///                        the number of elements of q and of v
///   displace             from (y, d, to): sets the positions of `to` to those of y moved by the displacement
///                        d
///   displacement         from (y, to, d): the displacement d from the positions of y to those of `to`
///   displacement_rate    from (d, v, rate): the rate of a displacement d from a fixed state while the
///                        positions move with v
///   position_rate        from (y, v, rate): q', the rate of the position coordinates of y, from v
///   position_sizes       from (y, sizes): for each number of a displacement the size that its relative error
///                        refers to, such as the distance of a body from the origin [m]
///
/// Laws: displacement is the inverse of displace; displacement_rate(0, v) = v; position_rate is the part of
/// y' that belongs to q.
template <class System>
concept HasDisplacements = FirstOrderSystem<System> &&
    requires(const System& system, const StateVector<typename System::Scalar>& y,
             const StateVector<typename System::Scalar>& v, StateVector<typename System::Scalar>& changed) {
  { system.position_size() } -> std::convertible_to<int>;
  { system.velocity_size() } -> std::convertible_to<int>;
  system.displace(y, v, changed);
  system.displacement(y, y, changed);
  system.displacement_rate(v, v, changed);
  system.position_rate(y, v, changed);
  system.position_sizes(y, changed);
};

}  // namespace trivium::integrators
