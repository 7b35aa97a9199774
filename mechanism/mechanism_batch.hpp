#pragma once
/// Mechanisms of one structure side by side in the lanes of a batch, for sweeps over masses, inertias,
/// points, axes and the coefficients of effects.

#include <fmt/format.h>

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "bodies/numbers/batch.hpp"
#include "mechanism/mechanism_cast.hpp"

namespace trivium {

namespace detail {

/// Shows every part of a mechanism to a visitor, in one order for all Scalars: numbers, one by one, and what
/// is not a number of its Scalar.
template <class Visit>
class Parts {
 public:
  explicit Parts(const Visit& visit) : visit_(visit) {}

  template <class M>
  void of(M& mechanism) const {
    each(mechanism.body_names);
    each(mechanism.row_names);
    for (auto& body : mechanism.bodies) show(body.mass, body.inertia);
    for (auto& row : mechanism.rows) std::visit([this](auto& c) { of_row(c); }, row);
    for (auto& joint : mechanism.joints) {
      const int type = static_cast<int>(joint.type);
      show(type, joint.i, joint.j, joint.name, joint.first_row, joint.rows, joint.angle);
      for (auto* frame : {&joint.frame_i, &joint.frame_j}) show(frame->point, frame->u, frame->v, frame->z);
    }
    of_effects(mechanism.effects);
  }

 private:
  template <class... Part>
  void show(Part&... parts) const {
    (visit_(parts), ...);
  }
  template <class List>
  void each(List& list) const {
    for (auto& part : list) visit_(part);
  }

  template <class Row>
  void of_row(Row& c) const {
    show(c.i, c.j);
    if constexpr (requires { c.f; }) show(c.f);
    if constexpr (requires { c.alpha; }) show(c.alpha, c.u_bar_i, c.v_bar_i);
    if constexpr (requires { c.a_bar_i; }) show(c.a_bar_i);
    if constexpr (requires { c.a_bar_j; }) show(c.a_bar_j);
    if constexpr (requires { c.c; }) show(c.c);
    if constexpr (requires { c.s_bar_i; }) show(c.s_bar_i, c.s_bar_j);
  }

  template <template <class> class List, class S>
  void of_effects(List<S>& effects) const {
    for_each_effect<S>(effects);
  }
  template <template <class> class List, class S>
  void of_effects(const List<S>& effects) const {
    for_each_effect<S>(effects);
  }
  template <class S, class List>
  void for_each_effect(List& effects) const {
    for (auto& e : effects.template all<Gravity<S>>()) show(e.g);
    for (auto& e : effects.template all<Force<S>>()) {
      const int frame = static_cast<int>(e.frame);
      show(frame, e.body, e.s_bar);
      each(e.components);
    }
    for (auto& e : effects.template all<Torque<S>>()) {
      const int frame = static_cast<int>(e.frame);
      show(frame, e.body);
      each(e.components);
    }
    for (auto& e : effects.template all<SpringDamper<S>>())
      show(e.i, e.j, e.s_bar_i, e.s_bar_j, e.stiffness, e.damping, e.free_length, e.actuator);
    for (auto& e : effects.template all<TorsionalSpringDamper<S>>())
      show(e.i, e.j, e.u_bar_i, e.v_bar_i, e.z_bar_i, e.u_bar_j, e.stiffness, e.damping, e.free_angle,
           e.actuator, e.followed);
  }

  const Visit& visit_;
};

/// A mechanism taken apart.
template <class T>
struct TakenApart {
  using NotANumber = std::variant<int, std::string, TimeFunction>;
  std::vector<T> numbers;
  std::vector<NotANumber> structure;

  explicit TakenApart(const Mechanism<T>& mechanism) {
    const auto take = [this]<class Part>(const Part& part) {
      if constexpr (std::is_same_v<Part, T>)
        numbers.push_back(part);
      else if constexpr (std::is_constructible_v<NotANumber, Part>)
        structure.emplace_back(part);
      else
        numbers.insert(numbers.end(), part.data(), part.data() + part.size());
    };
    Parts(take).of(mechanism);
  }
};

}  // namespace detail

/// As many mechanisms as there are lanes. Throws a ModelError where they differ in anything but numbers:
/// functions of time, and so the lengths of distance constraints, are one for all lanes.
template <class T, int N>
Mechanism<Batch<T, N>> pack(std::span<const Mechanism<T>, N> mechanisms) {
  auto all = mechanism_cast<Batch<T, N>>(mechanisms[0]);
  const detail::TakenApart<T> first(mechanisms[0]);
  for (int lane = 1; lane < N; ++lane) {
    const detail::TakenApart<T> parts(mechanisms[lane]);
    if (parts.structure != first.structure || parts.numbers.size() != first.numbers.size())
      throw ModelError(fmt::format(
          "mechanism {} of a batch, \"{}\", has other names, joints or functions of time than the "
          "first; only numbers may differ, and those of functions of time may not",
          lane + 1, mechanisms[lane].name));
    auto next = parts.numbers.begin();
    const auto put = [&]<class Part>(Part& part) {
      if constexpr (std::is_same_v<Part, Batch<T, N>>)
        part.set(lane, *next++);
      else if constexpr (requires { part.data()->set(lane, *next); })
        for (Batch<T, N>& x : part.reshaped()) x.set(lane, *next++);
    };
    detail::Parts(put).of(all);
  }
  return all;
}

}  // namespace trivium
