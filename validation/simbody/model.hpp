#pragma once
/// A scene as Simbody is told of it, and what Simbody answers: plain C++17 data without a SimTK type, because
/// Simbody's headers are not C++20 and the rest of the project is.
///
/// Simbody solves M u' + G^T lambda = f with G the Jacobian of its constraint error, so where its error is
/// our Phi its multiplier (lambda_S) is our lambda. Sign and scale of every mapping:
///
/// - Constraint::Custom, error Phi: DP1, turning DP1, DP2, D and CD with f(t). lambda = lambda_S.
/// - Ball, error p_j - p_i in Ground: CD(e_x), CD(e_y), CD(e_z). lambda = lambda_S.
/// - ConstantAngle, error a_i/|a_i| . a_j/|a_j| - cos(angle): DP1. lambda = lambda_S / (|a_i| |a_j|).
/// - PointInPlane, error a_i/|a_i| . p_j - height: DP2, or CD with i on Ground. lambda = lambda_S / |a_i|.
/// - Rod, error |d| - L, and d . d - L^2 = (|d| - L) (|d| + L): D. lambda = lambda_S / (2 L).
/// - ConstantOrientation, errors y_i . x_j, z_i . y_j, x_i . z_j with (x, y, z) = (u, v, z):
///   lambda(u_i, z_j) = lambda_S[2] and, because on the manifold v_i . u_j varies as -(u_i . v_j) and z_i .
///   v_j as -(v_i . z_j), lambda(u_i, v_j) = -lambda_S[0] and lambda(v_i, z_j) = -lambda_S[1].
/// - Weld: ConstantOrientation's rows, then Ball's.
///
/// Ball and PointInPlane act on the material point of body i that coincides with the point of body j, so
/// their lambda is ours on the constraint manifold only, like Rod's and ConstantOrientation's.
///
/// `calcConstraintForcesFromMultipliers` returns +G^T lambda: a reaction is its negative.
/// `calcMobilizerReactionForces` is the force on the child, at the mobilizer frame M, in Ground components.

#include <array>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace trivium::simbody {

using Vector3 = std::array<double, 3>;
using Matrix3 = std::array<Vector3, 3>;  ///< row by row

/// The body index of the ground, in every pair of bodies.
inline constexpr int ground = -1;

/// f(t) as {f, f', f''}; `is_number` says that it does not depend on t.
struct TimeFunction {
  std::function<Vector3(double)> value = [](double) { return Vector3{}; };
  bool is_number = true;
};

struct Body {
  std::string name;
  double mass = 0;
  Matrix3 inertia{};  ///< Jbar
  Vector3 position{};
  std::array<double, 4> euler_parameters{1, 0, 0, 0};
  Vector3 velocity{}, angular_velocity{};  ///< global; body frame (omega_bar)
};

struct BodyPair {
  int i = ground, j = ground;
};

enum class RowType { dp1, turning_dp1, dp2, d, cd };

/// A basic constraint of one row (constraints/basic_constraint.hpp has the equations).
struct Row : BodyPair {
  RowType type = RowType::dp1;
  Vector3 a_i{}, a_j{};  ///< body vectors; a_i is u_i of a turning DP1, and c of a CD (global)
  Vector3 v_i{};         ///< turning DP1
  Vector3 s_i{}, s_j{};  ///< points
  TimeFunction f;        ///< alpha(t) of a turning DP1
};

enum class JointType { revolute, universal, spherical, cylindrical, translational, planar, fixed, other };

struct JointFrame {
  Vector3 point{}, u{1, 0, 0}, v{0, 1, 0}, z{0, 0, 1};
};

/// A constraint of the scene and the rows that are its own; `other` is what Simbody has no mobilizer for.
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

/// How a model is rebuilt.
enum class Way {
  /// A spanning tree of joints as mobilizers; what closes it, as custom constraints. Closing rows that the
  /// tree
  /// satisfies identically (a second hinge on the same axis) are disabled: Simbody decides rank relative to
  /// the largest row, so that where all closing rows vanish it takes their rounding for a constraint.
  mobilizers,
  free_bodies,  ///< every body free on Ground; every row a custom constraint
  built_in      ///< every body free on Ground; Simbody's own constraints where one exists, else custom ones
};

/// Force, and torque about `point` (the joint's point on body i), Ground components.
struct Reaction {
  Vector3 force{}, torque{}, point{};
};

struct Answer {
  std::vector<Vector3> r_ddot;         ///< of the centres of mass, global
  std::vector<Vector3> omega_bar_dot;  ///< body frame
  std::vector<double> lambda;          ///< one per row; 0 where `lambda_known` is false
  std::vector<bool> lambda_known;      ///< false in the rows of a joint that became a mobilizer
  /// Per joint, on either body. They are opposite but for a CD whose points are apart: it acts along its own
  /// direction at both points, not along the line between them.
  std::vector<Reaction> reactions_on_i, reactions_on_j;
  double pose_defect = 0;      ///< the largest difference of a pose or velocity from the model's state
  double jacobian_defect = 0;  ///< the largest entry of G (from errors) - G (from forces)
  int mobilizers = 0;          ///< joints that became mobilizers
  int idle_rows = 0;           ///< closing rows that the tree satisfies identically: disabled, lambda 0
  int constraint_rows = 0;     ///< rows that became constraints
};

/// The joints that become mobilizers, in the order of the tree; none where the way has free bodies only.
std::vector<int> mobilizers(const Model& model, Way way);

/// Simbody would not build or solve the model; its message, on one line.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws Refused, and nothing else; what it returns is finite.
Answer solve(const Model& model, Way way);

// motions, by Simbody's own integrators

/// Those that control their errors: all but a semi-explicit Euler at given steps.
enum class Integrator {
  explicit_euler,
  semi_explicit_euler_2,
  verlet,
  runge_kutta_2,
  runge_kutta_3,
  runge_kutta_merson,
  runge_kutta_feldberg,
  cpodes_adams,
  cpodes_bdf
};

/// Where a body is and how it moves: p of e0 first, omega_bar in the body frame.
struct BodyState {
  Vector3 r{};
  std::array<double, 4> p{};
  Vector3 r_dot{}, omega_bar{};
};

struct Motion {
  std::vector<std::vector<BodyState>> states;  ///< of all bodies, at every time asked for
  double seconds = 0;                          ///< of this thread's CPU, from the first state to the last
  long steps = 0, realizations = 0;
};

/// Through the times, which steps end at but for those of CPodes, that interpolates; constraints to the
/// accuracy. Throws Refused, and nothing else.
Motion move(const Model& model, Way way, Integrator integrator, double accuracy,
            const std::vector<double>& times);

}  // namespace trivium::simbody
