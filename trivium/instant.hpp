#pragma once
/// The state of a mechanism at one time, with its accelerations, multipliers and joint reactions. Solution
/// (trivium/solve.hpp) and Output (trivium/simulate.hpp) are instants with more members. Numbers are found by
/// the names of bodies, joints and rows.

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "trivium/scene.hpp"

namespace trivium {

/// The names of a scene's parts, in the order of the scene. `joints` are constraints of all types; a basic
/// constraint (dp1, dp2, d, cd) is a joint of one row. A row is one scalar equation of a constraint, such as
/// "tip.cd(e_y)"; it has one multiplier lambda.
struct Names {
  std::vector<std::string> bodies;          ///< [nb], without the ground
  std::vector<std::string> joints;          ///< one per joint
  std::vector<std::string> rows;            ///< [nc]
  std::vector<std::string> joint_bodies_i;  ///< per joint: the name of its body i, or "ground"
  std::vector<std::string> joint_bodies_j;  ///< per joint: the name of its body j, or "ground"
};

/// Motion of a body at an instant. r is the position of its centre of mass.
struct BodyInstant {
  Components r{};                       ///< position [m], [3], global frame
  Components r_dot{};                   ///< velocity [m/s], [3], global frame
  Components r_ddot{};                  ///< acceleration [m/s^2], [3], global frame
  std::array<double, 4> p{1, 0, 0, 0};  ///< unit Euler parameters (e0, e1, e2, e3) of A, body to global [-]
  Components omega_bar{};               ///< angular velocity [rad/s], [3], body frame
  Components omega_bar_dot{};           ///< angular acceleration [rad/s^2], [3], body frame
};

/// Force and torque that a joint exerts on its body j (Names::joint_bodies_j), in the global frame. The
/// torque is about `point`, the joint's point on body i. The force on body i is opposite, and so is
/// the torque about this point, except for a cd whose points are apart.
struct JointReaction {
  Components force{};   ///< force on body j [N], [3], global frame
  Components torque{};  ///< torque on body j about `point` [N m], [3], global frame
  Components point{};   ///< position of the joint's point on body i [m], [3], global frame
};

/// Motion of a body-fixed point, in the global frame.
struct PointMotion {
  Components position{};      ///< [m], [3], global frame
  Components velocity{};      ///< [m/s], [3], global frame
  Components acceleration{};  ///< [m/s^2], [3], global frame
};

/// Everything that is known at one time. Vectors are in the order of `names`.
struct Instant {
  std::shared_ptr<const Names> names;  ///< shared by all outputs of a motion
  double t = 0;                        ///< time [s]
  std::vector<BodyInstant> bodies;     ///< per body: its pose, velocities and accelerations
  /// Multiplier of every row in M q'' + Phi_q^T lambda = Q. Its unit is J divided by the unit of the row Phi:
  /// N for rows in m (cd, dp2 of a unit vector), N m for dp1 of unit vectors, N/m for rows in m^2 (d). If a
  /// scene multiplies a row by a factor, such as the length of its vector, lambda is divided by this factor.
  ///
  /// Where rows are dependent, lambda is the solution with the least |E lambda|, E^2 = diag(Phi_q M^-1
  /// Phi_q^T). In two cases lambda is 0 in dependent rows instead. First, the structured solver (all outputs
  /// of simulate; solve above 6000 unknowns) does not know E if an inertia is singular. Second, near a
  /// singular position that a simulation passes, the solution with the least |E lambda| may not exist.
  std::vector<double> lambda;
  std::vector<bool> lambda_is_unique;  ///< per row: false if dependent rows leave its multiplier undetermined
  std::vector<JointReaction> reactions;  ///< per joint: its force and torque on body j
  std::vector<std::string> charts;  ///< per body, its chart of Euler angles; no elements in r-omega and r-p
  double lambda_error = 0;          ///< estimated relative error of lambda at t [-]
  double acceleration_error = 0;    ///< estimated relative error of the accelerations at t [-]

  /// Motion of the body with this name. An unknown name throws an Error of kind input that lists the known
  /// names; so do the functions below.
  const BodyInstant& body(std::string_view name) const;
  /// Reaction of the joint with this name. Throws an Error of kind input for an unknown name.
  const JointReaction& reaction(std::string_view joint) const;
  /// Multiplier of the row with this name, in the unit of `lambda`. Throws an Error of kind input for an
  /// unknown name.
  double lambda_of(std::string_view row) const;
  /// Motion, in the global frame, of the point with the body-frame coordinates s_bar [m], [3], from the
  /// centre of mass. Throws an Error of kind input for an unknown name.
  PointMotion point(std::string_view body, const Components& s_bar) const;
};

}  // namespace trivium
