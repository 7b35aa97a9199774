#pragma once
/// The third part of a formulation: its coordinates moved in time, as numbers that integrators carry. An
/// orientation of orientation_size numbers, and a velocity of which the rotational unknown is the derivative.

#include <concepts>

#include "bodies/rotations/so3.hpp"

namespace trivium {

template <class F>
concept MovingCoordinates = requires(const typename F::Scalar& s, const typename F::Chart& chart,
                                     const Vector4<typename F::Scalar>& p, const typename F::Coordinates& q,
                                     const typename F::Unknown& x, const typename F::Orientation& orientation,
                                     typename F::Orientation& moved, typename F::Unknown& moved_x) {
  // orientation and velocity, and the coordinates that they are
  { F::orientation_size } -> std::convertible_to<int>;
  { F::orientation_of(chart, p) } -> std::convertible_to<typename F::Orientation>;
  { F::velocity_of(chart, q) } -> std::convertible_to<typename F::Unknown>;
  { F::from_orientation(chart, orientation, x) } -> std::same_as<typename F::Coordinates>;
  // the orientation's rate; its retraction, rates kept; and what meets the internal row and its derivative
  { F::orientation_rate(chart, orientation, x) } -> std::convertible_to<typename F::Orientation>;
  { F::retract(chart, orientation, x) } -> std::convertible_to<typename F::Orientation>;
  F::normalise(moved, moved_x);
  // steps of implicit methods, in the same numbers: where a displacement leads, off the internal row too, and
  // from where to where it is; how it grows where the body moves with a velocity; the way back onto the
  // internal row and its derivative (by a share of what is added to the unknown); whether M depends on q
  { F::step(chart, orientation, x) } -> std::convertible_to<typename F::Orientation>;
  { F::displacement(chart, orientation, orientation) } -> std::convertible_to<typename F::Unknown>;
  { F::displacement_rate(x, x) } -> std::convertible_to<typename F::Unknown>;
  F::normalise_step(moved, s, moved_x);
  F::normalise_step_velocity(orientation, x, s, moved_x);
  { F::inertia_is_constant } -> std::convertible_to<bool>;
};

}  // namespace trivium
