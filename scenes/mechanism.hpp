#pragma once
/// What the equations make of a scene: bodies, constraint rows and effects in one Scalar, names resolved to
/// indices, axes normalised. The ground is the last body index everywhere: index nb, with no mass and no
/// coordinates.

#include <algorithm>
#include <string>
#include <vector>

#include "constraints/joint.hpp"
#include "effects/effects.hpp"
#include "scenes/scene.hpp"

namespace trivium {

/// One constraint of the scene (basic or joint) and the rows that are its own.
template <class Scalar>
struct Joint : BodyPair {
  std::string name;
  scenes::ConstraintType type = scenes::ConstraintType::spherical;
  JointFrame<Scalar> frame_i, frame_j;  ///< for joints with axes; a basic constraint has its points here
  int first_row = 0, rows = 0;
  TimeFunction angle;  ///< rotation_driver: alpha(t)
};

template <class Scalar>
struct Mechanism {
  std::string name;
  std::vector<std::string> body_names;  ///< nb + 1, "ground" last
  std::vector<RigidBody<Scalar>> bodies;
  std::vector<BasicConstraint<Scalar>> rows;
  std::vector<std::string> row_names;  ///< "joint.dp1(u_i, z_j)", or the name of a basic constraint
  std::vector<Joint<Scalar>> joints;   ///< in file order; basic constraints are joints of one row
  Effects<Scalar> effects;

  /// Times where a function of time has a kink in its second derivative, in order.
  std::vector<double> kinks() const {
    std::vector<double> times;
    for (const BasicConstraint<Scalar>& row : rows) function_of(row).append_kinks(times);
    effects.append_kinks(times);
    std::sort(times.begin(), times.end());
    return times;
  }

  int nb() const { return static_cast<int>(bodies.size()); }
  int nc() const { return static_cast<int>(rows.size()); }
  int ground() const { return nb(); }
};

/// The mechanism of a scene in Scalar. The scene is trusted: the reader has proved it.
template <class Scalar>
Mechanism<Scalar> make_mechanism(const scenes::Scene& scene);

/// The state in the file, taken as the state at time t.
template <class Scalar>
MechanismState<Scalar> make_state(const scenes::Scene& scene, Scalar t = Scalar(0));

/// Euler parameters [-] of a stated orientation, unit to the last bit of Scalar.
template <class Scalar>
Vector4<Scalar> euler_parameters_of(const scenes::Orientation& orientation);

/// Writes poses and velocities back into a scene, rounded to double.
void set_state(scenes::Scene& scene, const MechanismState<double>& state);

}  // namespace trivium
