#pragma once
/// What may act on bodies. An effect sees poses and velocities, never coordinates, and adds wrenches.

#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bodies/rigid_body.hpp"
#include "effects/effect_keys.hpp"

namespace trivium {

/// All that an effect may look at: bodies and their motion at time t. The last motion is the ground's.
template <class Scalar>
struct EffectView {
  std::span<const RigidBody<Scalar>> bodies;
  std::span<const BodyMotion<Scalar>> motion;
  Scalar t;

  /// Bodies and motions must outlive the view.
  EffectView(std::span<const RigidBody<Scalar>> of_bodies, std::span<const BodyMotion<Scalar>> of_motion,
             const Scalar& time)
      : bodies(of_bodies), motion(of_motion), t(time) {}
  EffectView(std::vector<RigidBody<Scalar>>&&, std::span<const BodyMotion<Scalar>>, const Scalar&) = delete;
  EffectView(std::span<const RigidBody<Scalar>>, std::vector<BodyMotion<Scalar>>&&, const Scalar&) = delete;
};

/// The contract. `apply` adds to the wrenches (one per motion, the ground's last), `power` [W] is the rate at
/// which the effect does work on the bodies, `potential_energy` [J] its stored energy, 0 for an effect that
/// has none, and `nonconservative_power` what of the power is not taken from there; it is conservative if
/// that is always zero. `type` is what a scene file calls it, `name` what a scene calls this one, and `keys`
/// shows every part with its key in a scene file (effect_keys.hpp). Those of the library are compared by
/// `==`, too, as scenes are.
///
/// One that counts turns has `follow`, called at every state that a motion has reached, and `longest_step`
/// [s] after which it would lose count, one with functions of time `append_kinks`. One whose wrenches are
/// sums of parts that may cancel has `add_load_bounds`, which adds these by magnitude. One that looks at no
/// motion says `sees_motion = false`.
template <class E, class Scalar>
concept Effect = std::default_initializable<E> &&
    requires(const E& effect, const EffectView<Scalar>& view, std::span<Wrench<Scalar>> wrenches) {
  effect.apply(view, wrenches);
  { effect.power(view) } -> std::convertible_to<Scalar>;
  { effect.potential_energy(view) } -> std::convertible_to<Scalar>;
  { effect.nonconservative_power(view) } -> std::convertible_to<Scalar>;
  { effect.is_conservative() } -> std::same_as<bool>;
  { E::type } -> std::convertible_to<std::string_view>;
  { effect.name } -> std::convertible_to<std::string>;
  E::keys(KeyVisitor{}, effect);
};

/// One that pushes back where two bodies move apart, along one coordinate: with its `stiffness` and
/// `damping`, the `bodies` i and j, the `gradient` of the coordinate (what a push of 1 does to i and to j),
/// and `tension_scale`, the size [N, N m] of the numbers that its tension is a difference of. Implicit
/// methods take it into Newton's matrix. An effect that has `gradient` must have the rest.
template <class E, class Scalar>
concept Spring = requires(const E& effect, const EffectView<Scalar>& view) {
  { effect.stiffness } -> std::convertible_to<Scalar>;
  { effect.damping } -> std::convertible_to<Scalar>;
  { effect.bodies() } -> std::same_as<std::pair<int, int>>;
  { effect.gradient(view) } -> std::same_as<std::pair<Wrench<Scalar>, Wrench<Scalar>>>;
  { effect.tension_scale(view) } -> std::convertible_to<Scalar>;
};

}  // namespace trivium
