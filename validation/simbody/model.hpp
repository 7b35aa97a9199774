#pragma once
/// A scene in the form that the Simbody library gets: plain C++17 data without SimTK types. The reason is
/// that Simbody's headers do not compile as C++20, which the rest of the project uses. The answers are in
/// solve.hpp and motion.hpp.

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace trivium::simbody {

using Vector3 = std::array<double, 3>;
using Matrix3 = std::array<Vector3, 3>;  ///< three rows

/// The body index of the ground, in every pair of bodies.
inline constexpr int ground = -1;

/// f(t) as {f, f', f''}. `is_number` is true if f does not depend on t.
struct TimeFunction {
  std::function<Vector3(double)> value = [](double) { return Vector3{}; };
  bool is_number = true;
};

struct Body {
  std::string name;
  double mass = 0;
  Matrix3 inertia{};  ///< inertia matrix J_bar [kg m^2], body frame, about the centre of mass
  Vector3 position{};
  std::array<double, 4> euler_parameters{1, 0, 0, 0};
  Vector3 velocity{}, angular_velocity{};  ///< r_dot [m/s], global; omega_bar [rad/s], body frame
};

struct BodyPair {
  int i = ground, j = ground;
};

enum class RowType { dp1, turning_dp1, dp2, d, cd };

/// A row: one basic constraint (constraints/basic_constraint.hpp has the equations).
struct Row : BodyPair {
  RowType type = RowType::dp1;
  Vector3 a_i{}, a_j{};  ///< body vectors; a_i is u_i for a turning DP1, and c (global) for a CD
  Vector3 v_i{};         ///< v_i of a turning DP1
  Vector3 s_i{}, s_j{};  ///< points in the body frames
  TimeFunction f;        ///< right-hand side; alpha(t) for a turning DP1
};

enum class JointType { revolute, universal, spherical, cylindrical, translational, planar, fixed, other };

struct JointFrame {
  Vector3 point{}, u{1, 0, 0}, v{0, 1, 0}, z{0, 0, 1};
};

/// A constraint of the scene with its range of rows. Type `other` has no mobilizer in Simbody.
struct Joint : BodyPair {
  std::string name;
  JointType type = JointType::other;
  JointFrame frame_i, frame_j;
  int first_row = 0, rows = 0;
};

struct Force {
  int body = ground;
  Vector3 point{};
  std::array<TimeFunction, 3> components;
  bool in_body_frame = false;
};
struct Torque {
  int body = ground;
  std::array<TimeFunction, 3> components;
  bool in_body_frame = false;
};
struct SpringDamper : BodyPair {
  Vector3 point_i{}, point_j{};
  double stiffness = 0, damping = 0, free_length = 0;
  TimeFunction actuator;
};
struct TorsionalSpringDamper {
  int joint = 0;
  double stiffness = 0, damping = 0, free_angle = 0;
  TimeFunction actuator;
};

struct Model {
  double t = 0;
  std::vector<Body> bodies;
  std::vector<Row> rows;
  std::vector<Joint> joints;
  std::vector<Vector3> gravity;
  std::vector<Force> forces;
  std::vector<Torque> torques;
  std::vector<SpringDamper> springs;
  std::vector<TorsionalSpringDamper> torsional_springs;
};

}  // namespace trivium::simbody
