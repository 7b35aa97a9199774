#pragma once
/// Scenes whose motion is known by a formula or by an equation of one degree of freedom. The hard cases and
/// tests compare runs with them.

#include "mechanism/mechanism_state.hpp"
#include "scenes/scene.hpp"

namespace trivium::hard {

/// The complete elliptic integral K of the modulus k, from sqrt(1 - k^2): without cancellation where k is
/// nearly 1.
double complete_elliptic_integral(double complementary_modulus);

/// The height [m] at time t of the top of the catalogue (heavy_top) with another spin [rad/s]; it starts with
/// a horizontal axis.
double height_of_top(double spin, double t);

/// The time [s] in which a free body with diagonal inertia turns over once about its intermediate axis: half
/// the period of omega_bar. Its moments of inertia ascend, and its energy is less than that of a spin about
/// the intermediate axis with the same angular momentum.
double time_of_a_flip(const scenes::Body& body);
/// Its angular velocity [rad/s] at time t, in its own frame.
scenes::Vector3 angular_velocity_of_flips(const scenes::Body& body, double t);

/// A crank of length 1 m and a rod of the same length, whose end slides along the x axis, without gravity.
/// The crank turns by `rate` [rad/s] at first. Where the rod lies on the crank, both could also turn
/// together.
scenes::Scene rod_on_crank(double rate);
/// Its state at the state's time.
void set_rod_on_crank(MechanismState<double>& state, double rate);

/// A crank of 1 m and a rod of 2 m whose end slides along the x axis, without gravity. The crank starts at
/// 2 rad/s and turns round and round.
scenes::Scene slider_crank();
/// The time of a turn [s].
double period_of_slider_crank();

/// A stone of 1 kg that a spring with a damper keeps on a circle of radius 1 m, by 10 rad/s.
scenes::Scene orbit_on_spring(double stiffness, double damping = 0);
/// Its position and velocity at the state's time.
void set_orbit(MechanismState<double>& state);

/// Sets a body that turns about the global z axis: place and velocity of its centre of mass in the plane,
/// angle and angular velocity.
void set_in_plane(MechanismState<double>& state, int body, double x, double y, double angle, double x_dot,
                  double y_dot, double rate);

/// Sets the rods of the ladder of n loops (scenes/generators.hpp) at this angle [rad] to the x axis, turning
/// at `rate` [rad/s].
void set_ladder(MechanismState<double>& state, int n, double angle, double rate);

/// A state at time 0 with room for so many bodies.
MechanismState<double> state_of_size(std::size_t bodies);

/// A stone of 1 kg on a spring with a damper to the origin. It begins at x = 1 m, with a velocity along y.
scenes::Scene stone_on_spring(double stiffness, double damping, double free_length, double velocity);

}  // namespace trivium::hard
