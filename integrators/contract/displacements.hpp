#pragma once
/// State and displacement. y begins with q and v; what follows, if anything, is the work. Positions move by
/// displacements, which have as many numbers as v: on a Lie group q may have more.

#include <concepts>

#include "integrators/contract/first_order_system.hpp"

namespace trivium::integrators {

///   position_size, velocity_size
///                        how many numbers q and v have
///   displace             from (y, d, to): sets the positions of `to` to where the displacement d leads from
///                        those of y
///   displacement         from (y, to, d): the d that leads from y to `to`
///   displacement_rate    from (d, v, rate): how a displacement grows where positions move with v
///   position_rate        from (y, v, rate): how y's own numbers of positions grow with v
///   position_sizes       from (y, sizes): how large, number by number of a displacement, what it moves is;
///                        errors of positions count relative to it
///
/// Laws: displacement undoes displace; displacement_rate(0, v) = v; position_rate is the part of y' that
/// belongs to q.
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
