#pragma once
/// The effects of a mechanism: one vector per type, so that an absent type costs nothing. The one list of
/// types is here; to add an effect, write its file and enter it there, or outside the library add it by
/// `With`.

#include <concepts>
#include <limits>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/raise.hpp"
#include "effects/force.hpp"
#include "effects/gravity.hpp"
#include "effects/spring_damper.hpp"
#include "effects/torque.hpp"
#include "effects/torsional_spring_damper.hpp"

namespace trivium {

/// A list of types of effects, over any Scalar.
template <template <class> class... E>
struct EffectTypes {
  static_assert((Effect<E<double>, double> && ...));

  template <class Scalar>
  using In = std::tuple<std::vector<E<Scalar>>...>;
  template <class Scalar>
  using OneOf = std::variant<E<Scalar>...>;
  template <template <class> class... More>
  using With = EffectTypes<E..., More...>;
};

/// The list of the library.
using StandardEffects = EffectTypes<Gravity, Force, Torque, SpringDamper, TorsionalSpringDamper>;
static_assert(std::equality_comparable<StandardEffects::OneOf<double>>, "an effect without operator==");

template <class Scalar, class List = StandardEffects>
class Effects {
 public:
  template <class E>
  void add(E effect) {
    std::get<std::vector<E>>(lists_).push_back(std::move(effect));
  }
  template <class E>
  std::vector<E>& all() {
    return std::get<std::vector<E>>(lists_);
  }
  template <class E>
  const std::vector<E>& all() const {
    return std::get<std::vector<E>>(lists_);
  }
  /// The vectors of all types, as a tuple.
  auto& lists() { return lists_; }
  const auto& lists() const { return lists_; }

  /// Whether any effect looks at how bodies move.
  bool see_motion() const {
    return any([](const auto& effect) {
      if constexpr (requires { effect.sees_motion; })
        return effect.sees_motion;
      else
        return true;
    });
  }
  /// Whether any effect can lose count of turns in a long step.
  bool limit_steps() const {
    return any([](const auto& effect) {
      return requires(const EffectView<Scalar>& view) { effect.longest_step(view); };
    });
  }

  /// Adds every effect's wrenches; one wrench per motion, the ground's last.
  void apply(const EffectView<Scalar>& view, std::span<Wrench<Scalar>> wrenches) const {
    for_each([&](const auto& effect) { effect.apply(view, wrenches); });
  }
  /// The rate [W] at which all effects do work on the bodies.
  Scalar power(const EffectView<Scalar>& view) const {
    Scalar sum(0);
    for_each([&](const auto& effect) { sum += effect.power(view); });
    return sum;
  }
  /// The energy [J] that the effects store.
  Scalar potential_energy(const EffectView<Scalar>& view) const {
    Scalar sum(0);
    for_each([&](const auto& effect) { sum += effect.potential_energy(view); });
    return sum;
  }
  /// Whether all give back what they store.
  bool are_conservative() const {
    return !any([](const auto& effect) { return !effect.is_conservative(); });
  }
  /// What of all power is not taken from stored energy.
  Scalar nonconservative_power(const EffectView<Scalar>& view) const {
    Scalar sum(0);
    for_each([&](const auto& effect) {
      if (!effect.is_conservative()) sum += effect.nonconservative_power(view);
    });
    return sum;
  }
  /// The longest step [s] after which all effects can still be followed.
  Scalar longest_step(const EffectView<Scalar>& view) const {
    Scalar longest = std::numeric_limits<Scalar>::max();
    for_each([&](const auto& effect) {
      if constexpr (requires { effect.longest_step(view); })
        lower(longest, Scalar(effect.longest_step(view)));
    });
    return longest;
  }
  /// Calls visit(effect) for every Spring.
  template <class Visit>
  void for_each_spring(const Visit& visit) const {
    for_each([&](const auto& effect) {
      if constexpr (requires(const EffectView<Scalar>& view) { effect.gradient(view); }) {
        static_assert(Spring<std::remove_cvref_t<decltype(effect)>, Scalar>);
        visit(effect);
      }
    });
  }
  /// Calls visit(angle) for every angle of a joint that an effect counts over turns (JointAngle).
  template <class Visit>
  void for_each_angle(const Visit& visit) {
    std::apply([&](auto&... list) { (visit_angles(list, visit), ...); }, lists_);
  }
  /// Tells effects that count turns where the motion is.
  void follow(const EffectView<Scalar>& view) {
    std::apply([&](auto&... list) { (follow_list(list, view), ...); }, lists_);
  }
  /// Appends the times where their functions of time have kinks.
  void append_kinks(std::vector<double>& times) const {
    for_each([&](const auto& effect) {
      if constexpr (requires { effect.append_kinks(times); }) effect.append_kinks(times);
    });
  }

  /// Calls add(body, |F|, |n_bar|) for the parts of every wrench that may cancel, by magnitude.
  template <class Add>
  void add_load_bounds(const EffectView<Scalar>& view, const Add& add) const {
    for_each([&](const auto& effect) {
      if constexpr (requires { effect.add_load_bounds(view, add); }) effect.add_load_bounds(view, add);
    });
  }

 private:
  template <class Is>
  bool any(const Is& is) const {
    bool found = false;
    for_each([&](const auto& effect) { found = found || is(effect); });
    return found;
  }
  template <class Of>
  static void follow_list(Of& list, const EffectView<Scalar>& view) {
    if constexpr (requires { list.front().follow(view); })
      for (auto& effect : list) effect.follow(view);
  }
  template <class Visit>
  struct AngleVisitor : KeyVisitor {
    const Visit& visit;
    explicit AngleVisitor(const Visit& use) : visit(use) {}
    void joint(std::string_view, auto& angle) const { visit(angle); }
  };
  template <class Of, class Visit>
  static void visit_angles(Of& list, const Visit& visit) {
    for (auto& effect : list) Of::value_type::keys(AngleVisitor<Visit>(visit), effect);
  }
  template <class Visit>
  void for_each(const Visit& visit) const {
    std::apply([&](const auto&... list) { (visit_list(list, visit), ...); }, lists_);
  }
  template <class Of, class Visit>
  static void visit_list(const Of& list, const Visit& visit) {
    for (const auto& effect : list) visit(effect);
  }

  typename List::template In<Scalar> lists_;
};

}  // namespace trivium
