#pragma once
/// Scenes of drivers and loads that change suddenly or fast, lose their grip or demand too much. They serve
/// the family of drivers and tests of motions.

#include "scenes/scene.hpp"

namespace trivium::hard {

// A crank of 1 m about z whose angle is driven, with a bar on a hinge at its tip.

/// At 0.5 s the speed of the driver jumps by `jump` [rad/s].
scenes::Scene jump_of_speed(double jump);
/// At 0.5 s the acceleration of the driver jumps by `jump` [rad/s^2].
scenes::Scene jump_of_acceleration(double jump);
/// The driver turns at a constant speed [rad/s].
scenes::Scene fast_driver(double speed);

// A free body of 1 kg under a force along x, whose impulse is 1 N s.

/// The force is constant for `width` [s] around 0.51 s.
scenes::Scene rectangular_pulse(double width);
/// The force rises and falls by quintic steps of this width [s] before and after 0.51 s.
scenes::Scene smooth_pulse(double width);
/// Pulses of 1 N s each, ten widths [s] apart, that no event marks: powers of a cosine.
scenes::Scene unmarked_pulses(double width);

/// A wheel whose angle `start` + t is driven by a dp1 between two vectors, which have no grip at the angle 0.
scenes::Scene near_parallel(double start);
/// A slide along x whose distance from the ground is driven from 1 m to `least` and back, within 2 s. The row
/// d - L^2 has the gradient 2 L.
scenes::Scene closing_distance(double least);
/// Two links of 1 m, whose tip is driven away from the ground with constant speed; 2 m are reached at the
/// time `t`.
scenes::Scene infeasible(double t);

}  // namespace trivium::hard
