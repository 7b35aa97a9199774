#pragma once
/// The concept of an effect: gravity, a force, a torque or a spring that acts on bodies. An effect sees poses
/// and velocities of bodies, never the coordinates of a formulation, and adds wrenches to the bodies.

#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bodies/rigid_body.hpp"
#include "effects/effect_keys.hpp"

namespace trivium {

/// The state that an effect may read: the bodies and their motion at time t.
template <class Scalar>
struct EffectView {
  std::span<const RigidBody<Scalar>> bodies;   ///< nb bodies, without the ground
  std::span<const BodyMotion<Scalar>> motion;  ///< nb + 1 motions, the ground's last
  Scalar t;                                    ///< time [s]

  /// Keeps references: bodies and motions must outlive the view.
  EffectView(std::span<const RigidBody<Scalar>> of_bodies, std::span<const BodyMotion<Scalar>> of_motion,
             const Scalar& time)
      : bodies(of_bodies), motion(of_motion), t(time) {}
  EffectView(std::vector<RigidBody<Scalar>>&&, std::span<const BodyMotion<Scalar>>, const Scalar&) = delete;
  EffectView(std::span<const RigidBody<Scalar>>, std::vector<BodyMotion<Scalar>>&&, const Scalar&) = delete;
};

/// An effect must have
///
///     apply(view, wrenches)         adds its wrenches to `wrenches`, one per body and the ground's last
///     power(view)                   the rate of work on the bodies [W]
///     potential_energy(view)        the stored energy V [J]; 0 if the effect stores none
///     nonconservative_power(view)   the part of the power that does not come from V: power + dV/dt [W]
///     is_conservative()             true if nonconservative_power is always 0
///     type, name                    the name of the type in scene files, and of this effect in its scene
///     keys(visitor, e...)           static; presents every part with its key in a file (effect_keys.hpp)
///
/// and, for effects of the library, operator==. All but `keys` are const. The effect may also have
///
///     follow(view)                  not const; counts full revolutions; called at every accepted state
///     longest_step(view)            the longest step [s] after which `follow` cannot miscount a revolution
///     append_kinks(times)           appends to a std::vector<double> the times [s] at which its functions
///                                   of time are not smooth; steps end there, so that integrators keep
///                                   their order
///     add_load_bounds(view, add)    bounds of its wrenches, to estimate rounding errors. Calls add(body, F,
///                                   n_bar) with the magnitudes, by component, of terms that may cancel
///                                   [N, global; N m, body frame]
///     sees_motion = false           static; states that its wrenches do not depend on the motion
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

/// An effect that resists a change of one coordinate x between two bodies i and j, a length [m] or an angle
/// [rad]. `bodies` returns the indices of i and j. `gradient` gives the wrenches on i and j whose power is
/// x'; the spring acts with -tension times the gradient. `stiffness` [N/m or N m/rad] and `damping` [N s/m or
/// N m s/rad] are the derivatives of the tension by x and x'. `tension_scale` [N or N m] is the size of the
/// terms whose difference is the tension, to bound its rounding error. Implicit methods include springs in
/// Newton's matrix. An effect with `gradient` must be a Spring.
template <class E, class Scalar>
concept Spring = requires(const E& effect, const EffectView<Scalar>& view) {
  { effect.stiffness } -> std::convertible_to<Scalar>;
  { effect.damping } -> std::convertible_to<Scalar>;
  { effect.bodies() } -> std::same_as<std::pair<int, int>>;
  { effect.gradient(view) } -> std::same_as<std::pair<Wrench<Scalar>, Wrench<Scalar>>>;
  { effect.tension_scale(view) } -> std::convertible_to<Scalar>;
};

}  // namespace trivium
