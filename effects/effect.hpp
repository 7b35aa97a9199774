#pragma once
/// What may act on bodies. An effect sees poses and velocities, never coordinates, and adds wrenches.

#include <concepts>
#include <span>

#include "bodies/rigid_body.hpp"

namespace trivium {

/// All that an effect may look at: bodies and their motion at time t. The last motion is the ground's.
template <class Scalar>
struct EffectView {
  std::span<const RigidBody<Scalar>> bodies;
  std::span<const BodyMotion<Scalar>> motion;
  Scalar t;
};

/// The contract. `apply` adds to the wrenches (one per motion, the ground's last), `power` [W] is the rate at
/// which the effect does work on the bodies, `potential_energy` [J] its stored energy, 0 for an effect that
/// has none, and `nonconservative_power` what of the power is not taken from there; it is conservative if
/// that is always zero. One that counts turns has `follow`, called at every state that a motion has reached
/// and `longest_step` [s] after which it would lose count, one with functions of time `append_kinks`, and a
/// spring the `gradient` of what it measures, with its stiffness and damping. One whose wrenches are sums of
/// parts that may cancel has `add_load_bounds`, which adds these by magnitude. One that looks at no motion
/// says `sees_motion = false`.
template <class E, class Scalar>
concept Effect = requires(const E& effect, const EffectView<Scalar>& view,
                          std::span<Wrench<Scalar>> wrenches) {
  effect.apply(view, wrenches);
  { effect.power(view) } -> std::convertible_to<Scalar>;
  { effect.potential_energy(view) } -> std::convertible_to<Scalar>;
  { effect.nonconservative_power(view) } -> std::convertible_to<Scalar>;
  { effect.is_conservative() } -> std::same_as<bool>;
  // for casts and batches: every number, and nothing that a name is
  E::show_parts([](const auto&...) {}, effect);
};

}  // namespace trivium
