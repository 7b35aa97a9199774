#pragma once
/// The effects of a scene as its file states them, and the one list of them. Each shows its keys to a
/// visitor; reader, writer, checks and the tables of keys follow. What an effect does is said in effects/,
/// and which numbers of a file it takes in make_mechanism_impl.hpp.
///
/// A visitor has
///
///   body(key, index)        the body that a load acts on
///   joint(key, index)       a joint with an angle, by its place among the constraints
///   need(key, value), may(key, value)
///                           a number, vector, function of time, three of these, a frame, or a side; what
///                           `may` shows has a default

#include <array>
#include <string>
#include <string_view>
#include <variant>

#include "bodies/numbers/time_function.hpp"
#include "scenes/side.hpp"

namespace trivium::scenes {

enum class Frame { global, body };

struct Gravity {
  static constexpr std::string_view type = "gravity";
  std::string name;
  Vector3 acceleration{};
  bool operator==(const Gravity&) const = default;

  static void keys(auto&& visitor, auto& effect) { visitor.need("acceleration", effect.acceleration); }
};

struct Force {
  static constexpr std::string_view type = "force";
  std::string name;
  int body = 0;
  Vector3 point{};
  std::array<TimeFunction, 3> force;
  Frame frame = Frame::global;
  bool operator==(const Force&) const = default;

  static void keys(auto&& visitor, auto& effect) {
    visitor.body("body", effect.body);
    visitor.may("point", effect.point);
    visitor.need("force", effect.force);
    visitor.may("frame", effect.frame);
  }
};

struct Torque {
  static constexpr std::string_view type = "torque";
  std::string name;
  int body = 0;
  std::array<TimeFunction, 3> torque;
  Frame frame = Frame::global;
  bool operator==(const Torque&) const = default;

  static void keys(auto&& visitor, auto& effect) {
    visitor.body("body", effect.body);
    visitor.need("torque", effect.torque);
    visitor.may("frame", effect.frame);
  }
};

struct SpringDamper {
  static constexpr std::string_view type = "spring_damper";
  std::string name;
  Side i, j;
  double stiffness = 0, damping = 0, free_length = 0;
  TimeFunction actuator;
  bool operator==(const SpringDamper&) const = default;

  static void keys(auto&& visitor, auto& effect) {
    visitor.need("i", effect.i);
    visitor.need("j", effect.j);
    visitor.may("stiffness", effect.stiffness);
    visitor.may("damping", effect.damping);
    visitor.may("free_length", effect.free_length);
    visitor.may("actuator", effect.actuator);
  }
};

struct TorsionalSpringDamper {
  static constexpr std::string_view type = "torsional_spring_damper";
  std::string name;
  int joint = 0;  ///< index into Scene::constraints; a revolute or cylindrical
  double stiffness = 0, damping = 0, free_angle = 0;
  TimeFunction actuator;
  bool operator==(const TorsionalSpringDamper&) const = default;

  static void keys(auto&& visitor, auto& effect) {
    visitor.joint("joint", effect.joint);
    visitor.may("stiffness", effect.stiffness);
    visitor.may("damping", effect.damping);
    visitor.may("free_angle", effect.free_angle);
    visitor.may("actuator", effect.actuator);
  }
};

/// The list.
using Effect = std::variant<Gravity, Force, Torque, SpringDamper, TorsionalSpringDamper>;

/// Shows the keys of an effect of any type.
template <class Visitor, class AnEffect>
void visit_keys(Visitor&& visitor, AnEffect& effect) {
  std::visit([&](auto& one) { one.keys(visitor, one); }, effect);
}

}  // namespace trivium::scenes
