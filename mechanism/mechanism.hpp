#pragma once
/// What every formulation sees of a scene: bodies, constraint rows and effects in one Scalar, names resolved
/// to indices, axes normalised. The ground is the last body index everywhere: index nb, with no mass and no
/// coordinates.

#include <algorithm>
#include <string>
#include <vector>

#include "constraints/constraint_type.hpp"
#include "constraints/joint.hpp"
#include "effects/effect_list.hpp"
#include "mechanism/mechanism_state.hpp"

namespace trivium {

/// One constraint of the scene (basic or joint) and the rows that are its own.
template <class Scalar>
struct Joint : BodyPair {
  std::string name;
  ConstraintType type = JointType::spherical;
  JointFrame<Scalar> frame_i, frame_j;  ///< for joints with axes; a basic constraint has its points here
  int first_row = 0, rows = 0;
  TimeFunction angle;  ///< rotation_driver: alpha(t)

  /// use(part...) for every part of one joint or of several side by side.
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

/// Which types of constraints and effects a mechanism may have.
template <class C, class E>
struct MechanismTypes {
  using Constraints = C;
  using Effects = E;
};
using StandardTypes = MechanismTypes<StandardConstraints, StandardEffects>;

template <class Scalar, class Types = StandardTypes>
struct Mechanism {
  using Row = BasicConstraint<Scalar, typename Types::Constraints>;

  std::string name;
  std::vector<std::string> body_names;  ///< nb + 1, "ground" last
  std::vector<RigidBody<Scalar>> bodies;
  std::vector<Row> rows;
  std::vector<std::string> row_names;  ///< "joint.dp1(u_i, z_j)", or the name of a basic constraint
  std::vector<Joint<Scalar>> joints;   ///< in file order; basic constraints are joints of one row
  Effects<Scalar, typename Types::Effects> effects;

  /// Times where a function of time has a kink in its second derivative, in order.
  std::vector<double> kinks() const {
    std::vector<double> times;
    for (const Row& row : rows) function_of(row).append_kinks(times);
    effects.append_kinks(times);
    std::sort(times.begin(), times.end());
    return times;
  }

  int nb() const { return static_cast<int>(bodies.size()); }
  int nc() const { return static_cast<int>(rows.size()); }
  int ground() const { return nb(); }
};

}  // namespace trivium
