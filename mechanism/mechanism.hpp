#pragma once
/// The mechanism of a scene, as every formulation sees it: bodies, constraint rows and effects in one Scalar,
/// with names resolved to indices and axes normalised. The ground has the body index nb, one past the last
/// body; it has no mass and no coordinates.

#include <algorithm>
#include <string>
#include <vector>

#include "constraints/constraint_type.hpp"
#include "constraints/joint.hpp"
#include "effects/effect_list.hpp"
#include "mechanism/mechanism_state.hpp"
#include "mechanism/rank_tolerance.hpp"

namespace trivium {

/// One constraint of the scene, a joint or a basic constraint, and the range of its rows.
template <class Scalar>
struct Joint : BodyPair {
  std::string name;
  ConstraintType type = JointType::spherical;
  JointFrame<Scalar> frame_i, frame_j;  ///< points and axes; of a basic constraint only the points are set
  int first_row = 0, rows = 0;          ///< index of the first row in Mechanism::rows, and number of rows
  TimeFunction angle;                   ///< alpha(t) [rad] of a rotation_driver

  /// Calls use(a.m, b.m, ...) for every member m, where a, b, ... are the given joints.
  template <class Use, class... Part>
  static void show_parts(const Use& use, Part&... p) {
    BodyPair::show_parts(use, p...);
    use(p.name...);
    use(p.type.joint...);
    use(p.type.place...);
    JointFrame<Scalar>::show_parts(use, p.frame_i...);
    JointFrame<Scalar>::show_parts(use, p.frame_j...);
    use(p.first_row...);
    use(p.rows...);
    use(p.angle...);
  }
};

/// The types of constraints C (BasicConstraints) and effects E (EffectTypes) that a mechanism may contain.
template <class C, class E>
struct MechanismTypes {
  using Constraints = C;
  using Effects = E;
};
/// The types of the library.
using StandardTypes = MechanismTypes<StandardConstraints, StandardEffects>;

/// Bodies, constraint rows and effects of one scene, over one Scalar.
template <class Scalar, class Types = StandardTypes>
struct Mechanism {
  /// A constraint row: a basic constraint of any type of the list.
  using Row = BasicConstraint<Scalar, typename Types::Constraints>;

  std::string name;
  std::vector<std::string> body_names;    ///< nb + 1 names, "ground" last
  std::vector<RigidBody<Scalar>> bodies;  ///< nb bodies
  std::vector<Row> rows;                  ///< nc constraint rows
  std::vector<std::string> row_names;     ///< e.g. "hinge.dp1(u_i, z_j)", or the name of a basic constraint
  std::vector<Joint<Scalar>> joints;  ///< in the order of the file; basic constraints are joints of one row
  Effects<Scalar, typename Types::Effects> effects;
  double rank_tolerance = standard_rank_tolerance;  ///< decides which rows are dependent [-]

  /// Times [s], ascending, of the kinks of all functions of time (TimeFunction::append_kinks).
  std::vector<double> kinks() const {
    std::vector<double> times;
    for (const Row& row : rows) function_of(row).append_kinks(times);
    effects.append_kinks(times);
    std::sort(times.begin(), times.end());
    return times;
  }

  /// Whether a driver or a load is a function of time that is not constant.
  bool depends_on_time() const {
    return effects.depend_on_time() || std::any_of(rows.begin(), rows.end(), [](const Row& row) {
             return !function_of(row).is_constant();
           });
  }

  int nb() const { return static_cast<int>(bodies.size()); }  ///< number of bodies, without the ground
  int nc() const { return static_cast<int>(rows.size()); }    ///< number of constraint rows
  int ground() const { return nb(); }                         ///< body index of the ground
};

}  // namespace trivium
