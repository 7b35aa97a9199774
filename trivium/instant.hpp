#pragma once
/// A mechanism at an instant: how every body is and moves, by name. Solutions and the outputs of motions are
/// instants with more beside them.

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "trivium/scene.hpp"

namespace trivium {

/// The names of a scene's parts, in its order. A joint is a constraint of any type; a row is one scalar
/// equation of one, with one multiplier lambda.
struct Names {
  std::vector<std::string> bodies, joints, rows;
};

/// A body at an instant; r is its centre of mass.
struct BodyInstant {
  Components r{}, r_dot{}, r_ddot{};        ///< [m, m/s, m/s^2], global
  std::array<double, 4> p{1, 0, 0, 0};      ///< Euler parameters (e0, e), unit
  Components omega_bar{}, omega_bar_dot{};  ///< [rad/s, rad/s^2], body frame
};

/// What a joint does to its body j, about its point on i: global frame.
struct JointReaction {
  Components force{}, torque{}, point{};  ///< [N, N m, m]
};

/// A body-fixed point, global.
struct PointMotion {
  Components position{}, velocity{}, acceleration{};  ///< [m, m/s, m/s^2]
};

struct Instant {
  std::shared_ptr<const Names> names;
  double t = 0;  ///< [s]
  std::vector<BodyInstant> bodies;
  std::vector<double> lambda;  ///< per row; where rows depend on others, the choice of least |E lambda|
  std::vector<bool> lambda_is_unique;               ///< per row
  std::vector<JointReaction> reactions;             ///< per joint
  std::vector<std::string> charts;                  ///< per body; empty for formulations without
  double lambda_error = 0, acceleration_error = 0;  ///< estimates, relative

  // By name. Throw an Error that says what there is.
  const BodyInstant& body(std::string_view name) const;
  const JointReaction& reaction(std::string_view joint) const;
  double lambda_of(std::string_view row) const;
  /// The point s_bar [m] in the frame of a body.
  PointMotion point(std::string_view body, const Components& s_bar) const;
};

}  // namespace trivium
