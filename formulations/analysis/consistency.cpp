/// Divides the residual of every row by the norm of the row's gradient, and compares the axes of joints to
/// find wrong branches.

#include "formulations/analysis/consistency.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/raise.hpp"
#include "bodies/rotations/so3.hpp"

namespace trivium {

namespace {

using F = ROmega<double>;

double row_norm(const EquationsOfMotion<F>::Row& row, double length, bool is_angle) {
  const double translation = row.r_i.squaredNorm() + row.r_j.squaredNorm();
  const double rotation = row.rot_i.squaredNorm() + row.rot_j.squaredNorm();
  const double norm = std::sqrt(is_angle ? rotation : translation + rotation / (length * length));
  return norm > 0 ? norm : 1.0;
}

/// Axes of a joint on both bodies in the global frame.
struct GlobalAxes {
  Vector3<double> u_i, v_i, z_i, u_j, z_j;
};

GlobalAxes global_axes(const MechanismState<double>& state, const Joint<double>& joint) {
  const auto A_of = [&](int b) -> Matrix3<double> {  // the ground follows the bodies
    if (b == static_cast<int>(state.pose.size())) return Matrix3<double>::Identity();
    return rotation_matrix(state.pose[b].p);
  };
  const Matrix3<double> A_i = A_of(joint.i), A_j = A_of(joint.j);
  return {A_i * joint.frame_i.u, A_i * joint.frame_i.v, A_i * joint.frame_i.z, A_j * joint.frame_j.u,
          A_j * joint.frame_j.z};
}

std::vector<std::string> wrong_branches_of(const Joint<double>& joint, const GlobalAxes& a, double t) {
  std::vector<std::string> wrong;
  const auto say = [&](const std::string& what) {
    wrong.push_back(fmt::format("joint \"{}\": {}", joint.name, what));
  };
  const JointProperties type = properties_of(joint.type);
  if (type.has_parallel_axes && a.z_i.dot(a.z_j) < 0) say("the axes z_i and z_j are antiparallel");
  if (type.allows_no_rotation && a.u_i.dot(a.u_j) < 0)
    say("the x axes u_i and u_j point in opposite directions");
  if (type.drives_an_angle) {
    const double theta = std::atan2(a.v_i.dot(a.u_j), a.u_i.dot(a.u_j));
    if (std::cos(theta - joint.angle(t).f) < 0)
      say("the angle of the joint is 180 degrees from the driven angle alpha(t)");
  }
  return wrong;
}

void append_offenders(std::string& text, const std::vector<RowViolation>& violations, const char* what) {
  std::vector<RowViolation> bad;
  for (const RowViolation& v : violations)
    if (v.exceeds) bad.push_back(v);
  std::sort(bad.begin(), bad.end(),
            [](const RowViolation& a, const RowViolation& b) { return a.size > b.size; });
  for (const RowViolation& v : bad)
    text += fmt::format("  {} {}: residual {:.3e}, {:.1e} {} (tolerance {:.1e})\n", v.row, what, v.residual,
                        v.size, v.unit, v.tolerance);
}

bool all_met(const std::vector<RowViolation>& violations) {
  return std::none_of(violations.begin(), violations.end(), [](const RowViolation& v) { return v.exceeds; });
}

}  // namespace

double worst_size(const std::vector<RowViolation>& violations) {
  double worst = 0;
  for (const RowViolation& v : violations) raise(worst, v.size);
  return worst;
}

Extent extent_of(const Mechanism<double>& mechanism, const MechanismState<double>& state) {
  Extent m;
  for (const auto& pose : state.pose) raise(m.length, pose.r.norm());
  for (const auto& joint : mechanism.joints)
    m.length = std::max({m.length, joint.frame_i.point.norm(), joint.frame_j.point.norm()});
  if (m.length == 0) m.length = 1;
  for (const auto& twist : state.twist)
    m.speed = std::max({m.speed, twist.r_dot.norm(), twist.omega_bar.norm() * m.length});
  return m;
}

VectorX<double> velocity_residual(const EquationsOfMotion<F>& eom) {
  VectorX<double> residual(eom.nc());
  for (int k = 0; k < eom.nc(); ++k) {
    const auto& row = eom.row[k];
    const auto &i = eom.body[eom.pair[k].i], &j = eom.body[eom.pair[k].j];
    residual[k] = row.r_i.dot(i.r_dot) + row.rot_i.dot(i.omega_bar) + row.r_j.dot(j.r_dot) +
                  row.rot_j.dot(j.omega_bar) - row.nu;
  }
  return residual;
}

bool Consistency::holds_positions() const { return wrong_branches.empty() && all_met(positions); }
bool Consistency::holds_rows() const { return all_met(positions) && all_met(velocities); }
bool Consistency::holds() const { return wrong_branches.empty() && holds_rows(); }

std::string Consistency::report() const {
  std::string text;
  append_offenders(text, positions, "position");
  append_offenders(text, velocities, "velocity");
  for (const std::string& branch : wrong_branches) text += fmt::format("  {} (a wrong branch)\n", branch);
  return text;
}

Consistency check_consistency(const Mechanism<double>& mechanism, const MechanismState<double>& state) {
  const auto eom = equations_of_motion<F>(mechanism, to_coordinates<F>(mechanism, state, {}), state.t);
  const Extent m = extent_of(mechanism, state);
  Consistency out;
  // Relative to the length and speed of the mechanism. Positions within 1e-8 leave redundant rows dependent
  // up to rank_tolerance.
  constexpr double tolerance = 1e-8;
  // [1/s], speed tolerance per length. A mechanism at rest has speed 0 and gives no scale for its velocities.
  // 1e-12 is far above their rounding errors (about 1e-16 per second) and far below the speed of a motion.
  constexpr double rate_of_rounding = 1e-12;
  const VectorX<double> velocity = velocity_residual(eom);
  for (int k = 0; k < eom.nc(); ++k) {
    const bool is_angle = is_of_angle(mechanism.rows[k]);
    const double norm = row_norm(eom.row[k], m.length, is_angle);
    const double length = is_angle ? 1.0 : m.length, speed = is_angle ? m.speed / m.length : m.speed;
    const auto judge = [&](double residual, double most, const char* unit) {
      const double size = std::abs(residual) / norm;
      return RowViolation{mechanism.row_names[k], residual, size, most, unit, !(size <= most)};
    };
    out.positions.push_back(judge(eom.row[k].phi, tolerance * length, is_angle ? "rad" : "m"));
    out.velocities.push_back(
        judge(velocity[k], tolerance * speed + rate_of_rounding * length, is_angle ? "rad/s" : "m/s"));
  }
  out.wrong_branches = wrong_branches(mechanism.joints, state);
  return out;
}

std::vector<std::string> wrong_branches(const std::vector<Joint<double>>& joints,
                                        const MechanismState<double>& state) {
  std::vector<std::string> all;
  for (const Joint<double>& joint : joints)
    for (std::string& wrong : wrong_branches_of(joint, global_axes(state, joint), state.t))
      all.push_back(std::move(wrong));
  return all;
}

}  // namespace trivium
