#pragma once
/// A scene as a scene file states it: plain data in doubles and SI units, with no derived quantities. A scene
/// that has passed the reader has finite numbers, physical bodies and no dangling names. The equations use a
/// `Mechanism<Scalar>`, which make_mechanism.hpp makes from the scene.

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bodies/numbers/time_function.hpp"
#include "bodies/rotations/euler_sequence.hpp"
#include "constraints/basic_constraint.hpp"
#include "effects/effect_list.hpp"
#include "mechanism/rank_tolerance.hpp"
#include "mechanism/saved_run.hpp"
#include "scenes/side.hpp"

namespace trivium::scenes {

using Matrix3 = std::array<Vector3, 3>;  ///< three rows

/// Euler parameters of the rotation from body to global components.
struct EulerParameters {
  std::array<double, 4> e{1, 0, 0, 0};  ///< e0, e1, e2, e3 [-]; normalised when used
  bool operator==(const EulerParameters&) const = default;
};
/// Angles of successive rotations about body-fixed axes.
struct EulerAngles {
  Vector3 angles{};  ///< [rad], in the order of the sequence
  EulerSequence sequence;
  bool operator==(const EulerAngles&) const = default;
};
/// A rotation by an angle about an axis.
struct AxisAngle {
  Vector3 axis{0, 0, 1};  ///< of any length; the same components in both frames
  double angle = 0;       ///< [rad]
  bool operator==(const AxisAngle&) const = default;
};
/// A rotation matrix.
struct RotationMatrix {
  Matrix3 A{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< maps body components to global components
  bool operator==(const RotationMatrix&) const = default;
};
/// The orientation of a body, in any of four forms.
using Orientation = std::variant<EulerParameters, EulerAngles, AxisAngle, RotationMatrix>;

/// A body and its state.
struct Body {
  std::string name;
  double mass = 0;                         ///< [kg]
  std::variant<Vector3, Matrix3> inertia;  ///< diagonal or full [kg m^2], centre of mass, body frame
  bool unphysical_inertia = false;         ///< do not check the triangle inequality of the moments
  Vector3 position{};                      ///< r of the centre of mass [m], global frame
  Orientation orientation;
  Vector3 velocity{};          ///< velocity of the centre of mass [m/s], global frame
  Vector3 angular_velocity{};  ///< omega_bar [rad/s], body frame
  bool operator==(const Body&) const = default;
};

/// A constraint of any type. The members after `j` are parameters; each type uses some of them.
struct Constraint {
  ConstraintType type = JointType::spherical;
  std::string name;
  Side i, j;
  TimeFunction f;       ///< right-hand side, for basic constraints
  Vector3 direction{};  ///< direction c in the global frame, for basic constraints
  double distance = 0;  ///< length [m], for a distance joint
  TimeFunction angle;   ///< alpha(t) [rad], for a rotation_driver
  bool operator==(const Constraint&) const = default;
};

/// An effect in doubles. Its indices of bodies and joints refer to the lists of the scene.
using Effect = StandardEffects::OneOf<double>;

/// Calls the visitor for every key of an effect of any type (effects/effect_keys.hpp).
template <class Visitor, class AnEffect>
void visit_keys(Visitor&& visitor, AnEffect& effect) {
  std::visit([&](auto& one) { one.keys(visitor, one); }, effect);
}

/// The contents of a scene file.
struct Scene {
  std::string name, description, reference;  ///< reference: the source of the model
  std::vector<Body> bodies;
  std::vector<Constraint> constraints;
  std::vector<Effect> effects;
  std::optional<SavedRun> saved;                    ///< data to continue the run that ended in this state
  double rank_tolerance = standard_rank_tolerance;  ///< of the mechanism; no key of the format
  bool operator==(const Scene&) const = default;

  /// The name of the body with this index, also of `ground`.
  const std::string& body_name(int body) const {
    static const std::string ground_name = "ground";
    return body == ground ? ground_name : bodies[static_cast<std::size_t>(body)].name;
  }
};

/// The time [s] of a scene's state: t if given, else the time of the saved run, else 0.
inline double time_of(const Scene& scene, std::optional<double> t) {
  return t ? *t : scene.saved ? scene.saved->t : 0.0;
}

}  // namespace trivium::scenes
