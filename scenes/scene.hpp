#pragma once
/// A scene as its file states it: plain data in doubles, SI units, nothing derived. What has passed the
/// reader is finite, physical and free of dangling names; `Mechanism<Scalar>` is what the equations make of
/// it.

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bodies/numbers/time_function.hpp"
#include "bodies/rotations/euler_sequence.hpp"
#include "constraints/basic_constraint.hpp"
#include "effects/effect_list.hpp"
#include "mechanism/saved_run.hpp"
#include "scenes/side.hpp"

namespace trivium::scenes {

using Matrix3 = std::array<Vector3, 3>;  ///< row by row

struct EulerParameters {
  std::array<double, 4> e{1, 0, 0, 0};  ///< e0 first; normalised when used
  bool operator==(const EulerParameters&) const = default;
};
struct EulerAngles {
  Vector3 angles{};
  EulerSequence sequence;
  bool operator==(const EulerAngles&) const = default;
};
struct AxisAngle {
  Vector3 axis{0, 0, 1};
  double angle = 0;
  bool operator==(const AxisAngle&) const = default;
};
struct RotationMatrix {
  Matrix3 A{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< body to global
  bool operator==(const RotationMatrix&) const = default;
};
using Orientation = std::variant<EulerParameters, EulerAngles, AxisAngle, RotationMatrix>;

struct Body {
  std::string name;
  double mass = 0;
  std::variant<Vector3, Matrix3> inertia;  ///< diagonal or full, about the centre of mass, body frame
  bool unphysical_inertia = false;         ///< the triangle inequality is waived
  Vector3 position{};
  Orientation orientation;
  Vector3 velocity{};          ///< of the centre of mass, global
  Vector3 angular_velocity{};  ///< omega_bar, body frame
  bool operator==(const Body&) const = default;
};

/// What it states beside its type, name and sides; each type reads its own.
struct Constraint {
  ConstraintType type = JointType::spherical;
  std::string name;
  Side i, j;
  TimeFunction f;       ///< of basic constraints
  Vector3 direction{};  ///< of basic constraints, global
  double distance = 0;  ///< distance: its length
  TimeFunction angle;   ///< rotation_driver: alpha(t)
  bool operator==(const Constraint&) const = default;
};

/// An effect as it acts, in doubles: its bodies and its joint are those of the scene.
using Effect = StandardEffects::OneOf<double>;

/// Shows the keys of an effect of any type (effects/effect_keys.hpp).
template <class Visitor, class AnEffect>
void visit_keys(Visitor&& visitor, AnEffect& effect) {
  std::visit([&](auto& one) { one.keys(visitor, one); }, effect);
}

struct Scene {
  std::string name, description, reference;
  std::vector<Body> bodies;
  std::vector<Constraint> constraints;
  std::vector<Effect> effects;
  std::optional<SavedRun> saved;  ///< of a run that ended in this state
  bool operator==(const Scene&) const = default;

  const std::string& body_name(int body) const {
    static const std::string ground_name = "ground";
    return body == ground ? ground_name : bodies[static_cast<std::size_t>(body)].name;
  }
};

/// The time [s] of a scene's state: that asked for, else that of a saved run, else 0.
inline double time_of(const Scene& scene, std::optional<double> t) {
  return t ? *t : scene.saved ? scene.saved->t : 0.0;
}

}  // namespace trivium::scenes
