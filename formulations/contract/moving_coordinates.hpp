#pragma once
/// The third part of a formulation: the motion of its coordinates in time. Per body, an integrator holds an
/// orientation of orientation_size numbers and a rotational velocity; the rotational unknown is the time
/// derivative of this velocity.

#include <concepts>

#include "bodies/rotations/so3.hpp"

namespace trivium {

/// What a formulation F must have for simulations, in addition to the other two parts.
template <class F>
concept MovingCoordinates = requires(const typename F::Scalar& s, const typename F::Chart& chart,
                                     const Vector4<typename F::Scalar>& p, const typename F::Coordinates& q,
                                     const typename F::Unknown& x, const typename F::Orientation& orientation,
                                     typename F::Orientation& moved, typename F::Unknown& moved_x) {
  // orientation from a pose, velocity from coordinates, and coordinates from both
  { F::orientation_size } -> std::convertible_to<int>;
  { F::orientation_of(chart, p) } -> std::convertible_to<typename F::Orientation>;
  { F::velocity_of(chart, q) } -> std::convertible_to<typename F::Unknown>;
  { F::from_orientation(chart, orientation, x) } -> std::same_as<typename F::Coordinates>;
  // rate of the orientation; orientation after an increment, a velocity times a time (retraction): it
  // satisfies the internal row and is right to first order; and normalise, which makes orientation and
  // velocity satisfy the internal row and its time derivative
  { F::orientation_rate(chart, orientation, x) } -> std::convertible_to<typename F::Orientation>;
  { F::retract(chart, orientation, x) } -> std::convertible_to<typename F::Orientation>;
  F::normalise(moved, moved_x);
  // Steps of implicit methods are displacements with as many numbers as the velocity. step: the orientation
  // after a displacement, which may violate the internal row. displacement: the displacement from the first
  // to the second orientation. displacement_rate: time derivative of a displacement (first argument) at a
  // velocity (second argument). normalise_step finds the smallest change c of the unknown moved_x for which
  // the orientation `moved`, displaced by the number s times c, satisfies the internal row. It displaces
  // `moved` and adds c to moved_x. normalise_step_velocity adds to moved_x the smallest change c for which
  // the velocity x + s c satisfies the time derivative of the internal row at `orientation`.
  // inertia_is_constant: whether mass_block is independent of q
  { F::step(chart, orientation, x) } -> std::convertible_to<typename F::Orientation>;
  { F::displacement(chart, orientation, orientation) } -> std::convertible_to<typename F::Unknown>;
  { F::displacement_rate(x, x) } -> std::convertible_to<typename F::Unknown>;
  F::normalise_step(moved, s, moved_x);
  F::normalise_step_velocity(orientation, x, s, moved_x);
  { F::inertia_is_constant } -> std::convertible_to<bool>;
};

}  // namespace trivium
