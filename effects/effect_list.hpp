#pragma once
/// The effects of a mechanism, in one vector per type, so that an unused type costs nothing, and the list of
/// types. To add an effect, write its file and enter it in StandardEffects; other projects add it by `With`.

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

/// A list of types of effects, for any Scalar: `In<Scalar>` is a tuple of vectors, `OneOf<Scalar>` a variant.
template <template <class> class... E>
struct EffectTypes {
  static_assert((Effect<E<double>, double> && ...));

  template <class Scalar>
  using In = std::tuple<std::vector<E<Scalar>>...>;
  template <class Scalar>
  using OneOf = std::variant<E<Scalar>...>;
  /// The list with more types at its end.
  template <template <class> class... More>
  using With = EffectTypes<E..., More...>;
};

/// The effects of the library.
using StandardEffects = EffectTypes<Gravity, Force, Torque, SpringDamper, TorsionalSpringDamper>;
static_assert(std::equality_comparable<StandardEffects::OneOf<double>>, "an effect without operator==");

/// The effects of one mechanism.
template <class Scalar, class List = StandardEffects>
class Effects {
 public:
  /// Adds an effect of a type of the list.
  template <class E>
  void add(E effect) {
    std::get<std::vector<E>>(lists_).push_back(std::move(effect));
  }
  /// All effects of the type E, in the order in which they were added.
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

  /// Whether the wrenches of any effect depend on the motion.
  bool see_motion() const {
    return any([](const auto& effect) {
      if constexpr (requires { effect.sees_motion; })
        return effect.sees_motion;
      else
        return true;
    });
  }
  /// Whether any effect limits the step size because it counts revolutions (longest_step).
  bool limit_steps() const {
    return any([](const auto& effect) {
      return requires(const EffectView<Scalar>& view) { effect.longest_step(view); };
    });
  }

  /// Adds the wrenches of all effects to `wrenches` [nb + 1], the ground's last.
  void apply(const EffectView<Scalar>& view, std::span<Wrench<Scalar>> wrenches) const {
    for_each([&](const auto& effect) { effect.apply(view, wrenches); });
  }
  /// The rate of work of all effects on the bodies [W].
  Scalar power(const EffectView<Scalar>& view) const {
    Scalar sum(0);
    for_each([&](const auto& effect) { sum += effect.power(view); });
    return sum;
  }
  /// The energy stored in all effects [J].
  Scalar potential_energy(const EffectView<Scalar>& view) const {
    Scalar sum(0);
    for_each([&](const auto& effect) { sum += effect.potential_energy(view); });
    return sum;
  }
  /// Whether all effects are conservative.
  bool are_conservative() const {
    return !any([](const auto& effect) { return !effect.is_conservative(); });
  }
  /// The part of the power that does not come from stored energy [W].
  Scalar nonconservative_power(const EffectView<Scalar>& view) const {
    Scalar sum(0);
    for_each([&](const auto& effect) {
      if (!effect.is_conservative()) sum += effect.nonconservative_power(view);
    });
    return sum;
  }
  /// The longest step size [s] with which all effects can still count revolutions; NaN if one of them is NaN.
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
  /// Calls visit(angle) for every joint angle that an effect counts over full revolutions (JointAngle).
  template <class Visit>
  void for_each_angle(const Visit& visit) {
    std::apply([&](auto&... list) { (visit_angles(list, visit), ...); }, lists_);
  }
  /// Passes an accepted state of a motion to the effects that count revolutions.
  void follow(const EffectView<Scalar>& view) {
    std::apply([&](auto&... list) { (follow_list(list, view), ...); }, lists_);
  }
  /// Whether a function of time among the parts of an effect is not constant.
  bool depend_on_time() const {
    bool found = false;
    const auto look = [&](const auto& part) {
      if constexpr (requires { part.is_constant(); })
        found = found || !part.is_constant();
      else if constexpr (requires { part[0].is_constant(); })
        for (const auto& function : part) found = found || !function.is_constant();
    };
    for_each([&](const auto& effect) { show_effect_parts(look, effect); });
    return found;
  }
  /// Appends the times [s] at which functions of time of the effects have kinks (TimeFunction::append_kinks).
  void append_kinks(std::vector<double>& times) const {
    for_each([&](const auto& effect) {
      if constexpr (requires { effect.append_kinks(times); }) effect.append_kinks(times);
    });
  }

  /// Calls add(body, F, n_bar) with the magnitudes, component by component, of wrench terms that may cancel.
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
