#include "formulations/analysis/assemble.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace trivium {

namespace {

using F = ROmega<double>;

EquationsOfMotion<F> equations(const Mechanism<double>& mechanism, const MechanismState<double>& state) {
  return equations_of_motion<F>(mechanism, to_coordinates<F>(mechanism, state, {}), state.t);
}

/// The largest coordinate of any body or joint point, and the largest speed: what rounding scales with.
struct Extent {
  double length = 0, speed = 0;
};

Extent extent_of(const Mechanism<double>& mechanism, const MechanismState<double>& state) {
  Extent m;
  for (const auto& pose : state.pose) m.length = std::max(m.length, pose.r.norm());
  for (const auto& joint : mechanism.joints)
    m.length = std::max({m.length, joint.frame_i.point.norm(), joint.frame_j.point.norm()});
  if (m.length == 0) m.length = 1;
  for (const auto& twist : state.twist)
    m.speed = std::max({m.speed, twist.r_dot.norm(), twist.omega_bar.norm() * m.length});
  return m;
}

double row_norm(const EquationsOfMotion<F>::Row& row, double length, bool is_angle) {
  const double translation = row.r_i.squaredNorm() + row.r_j.squaredNorm();
  const double rotation = row.rot_i.squaredNorm() + row.rot_j.squaredNorm();
  const double norm = std::sqrt(is_angle ? rotation : translation + rotation / (length * length));
  return norm > 0 ? norm : 1.0;
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

/// z, u and v of a joint on both sides, global.
struct GlobalAxes {
  Vector3<double> u_i, v_i, z_i, u_j, z_j;
};

GlobalAxes global_axes(const EquationsOfMotion<F>& eom, const Joint<double>& joint) {
  const auto &A_i = eom.body[joint.i].A, &A_j = eom.body[joint.j].A;
  return {A_i * joint.frame_i.u, A_i * joint.frame_i.v, A_i * joint.frame_i.z, A_j * joint.frame_j.u,
          A_j * joint.frame_j.z};
}

std::vector<std::string> wrong_branches_of(const Joint<double>& joint, const GlobalAxes& a, double t) {
  using Type = ConstraintType;
  std::vector<std::string> wrong;
  const auto say = [&](const std::string& what) { wrong.push_back(fmt::format("{}: {}", joint.name, what)); };
  const bool axes = joint.type == Type::revolute || joint.type == Type::cylindrical ||
                    joint.type == Type::translational || joint.type == Type::fixed ||
                    joint.type == Type::planar;
  const bool no_rotation = joint.type == Type::translational || joint.type == Type::fixed;
  if (axes && a.z_i.dot(a.z_j) < 0) say("its axes z_i and z_j are antiparallel");
  if (no_rotation && a.u_i.dot(a.u_j) < 0) say("its x axes u_i and u_j are a half turn apart");
  if (joint.type == Type::rotation_driver) {
    const double theta = std::atan2(a.v_i.dot(a.u_j), a.u_i.dot(a.u_j));
    if (std::cos(theta - joint.angle(t).f) < 0) say("its angle is a half turn from alpha(t)");
  }
  return wrong;
}

/// The least change x, in the metric, with Phi x = c (least squares where rows contradict each other).
VectorX<double> least_change(const TangentSystem& system, const VectorX<double>& c,
                             double threshold = rank_tolerance) {
  const Metric metric(system);
  MatrixX<double> W = metric.half_solve(system.Phi.transpose());
  VectorX<double> scale = W.colwise().norm().transpose();
  for (double& s : scale) s = s > 0 ? 1 / s : 0.0;
  W = W * scale.asDiagonal();
  Eigen::CompleteOrthogonalDecomposition<MatrixX<double>> decomposition;
  decomposition.setThreshold(threshold);
  decomposition.compute(W.transpose());
  const VectorX<double> y = decomposition.solve(scale.cwiseProduct(c));
  return metric.half_solve_transposed(y);
}

void move(MechanismState<double>& state, const VectorX<double>& step) {
  for (std::size_t b = 0; b < state.pose.size(); ++b) {
    const Eigen::Index at = static_cast<Eigen::Index>(6 * b);
    state.pose[b].r += step.segment<3>(at);
    const Vector4<double> turn = exponential_parameters<double>(step.segment<3>(at + 3));
    state.pose[b].p = multiply_parameters<double>(state.pose[b].p, turn);
    state.pose[b].p /= state.pose[b].p.norm();
  }
}

VectorX<double> positions_residual(const EquationsOfMotion<F>& eom) {
  VectorX<double> phi(eom.nc());
  for (int k = 0; k < eom.nc(); ++k) phi[k] = eom.row[k].phi;
  return phi;
}

double worst_size(const std::vector<Violation>& violations) {
  double worst = 0;
  for (const Violation& v : violations) worst = std::max(worst, v.size);
  return worst;
}

void append_offenders(std::string& text, const std::vector<Violation>& violations, const char* what) {
  std::vector<Violation> bad;
  for (const Violation& v : violations)
    if (v.exceeds) bad.push_back(v);
  std::sort(bad.begin(), bad.end(), [](const Violation& a, const Violation& b) { return a.size > b.size; });
  for (const Violation& v : bad)
    text += fmt::format("  {} {}: residual {:.3e}, {:.1e} {} (tolerance {:.1e})\n", v.row, what, v.residual,
                        v.size, v.unit, v.tolerance);
}

}  // namespace

namespace {
bool all_met(const std::vector<Violation>& violations) {
  return std::none_of(violations.begin(), violations.end(), [](const Violation& v) { return v.exceeds; });
}
}  // namespace

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
  const auto eom = equations(mechanism, state);
  const Extent m = extent_of(mechanism, state);
  Consistency out;
  constexpr double tolerance = 1e-8;  // of the scene's own lengths and speeds
  const VectorX<double> velocity = velocity_residual(eom);
  for (int k = 0; k < eom.nc(); ++k) {
    const bool is_angle = is_of_angle(mechanism.rows[k]);
    const double norm = row_norm(eom.row[k], m.length, is_angle);
    const double length = is_angle ? 1.0 : m.length, speed = is_angle ? m.speed / m.length : m.speed;
    const auto judge = [&](double residual, double most, const char* unit) {
      const double size = std::abs(residual) / norm;
      return Violation{mechanism.row_names[k], residual, size, most, unit, !(size <= most)};
    };
    out.positions.push_back(judge(eom.row[k].phi, tolerance * length, is_angle ? "rad" : "m"));
    out.velocities.push_back(
        judge(velocity[k], tolerance * speed + 1e-12 * length, is_angle ? "rad/s" : "m/s"));
  }
  for (const Joint<double>& joint : mechanism.joints)
    for (std::string& wrong : wrong_branches_of(joint, global_axes(eom, joint), state.t))
      out.wrong_branches.push_back(std::move(wrong));
  return out;
}

void project_velocities(const Mechanism<double>& mechanism, MechanismState<double>& state) {
  for (int pass = 0; pass < 2; ++pass) {  // the second removes what rounding of the first left
    const VectorX<double> step =
        least_change(tangent_system(mechanism, state), -velocity_residual(equations(mechanism, state)));
    for (std::size_t b = 0; b < state.twist.size(); ++b) {
      state.twist[b].r_dot += step.segment<3>(static_cast<Eigen::Index>(6 * b));
      state.twist[b].omega_bar += step.segment<3>(static_cast<Eigen::Index>(6 * b + 3));
    }
  }
}

namespace {

double violation(const Mechanism<double>& mechanism, const MechanismState<double>& state) {
  return worst_size(check_consistency(mechanism, state).positions);
}

/// Gauss-Newton to the rounding level, steps halved where they do not help.
void close_gaps(const Mechanism<double>& mechanism, MechanismState<double>& state) {
  constexpr int most_steps = 100;
  const double length = extent_of(mechanism, state).length;
  double last = violation(mechanism, state);
  const auto improves = [&](double threshold) {
    const VectorX<double> change = least_change(tangent_system(mechanism, state),
                                                -positions_residual(equations(mechanism, state)), threshold);
    double fraction = 1;
    for (int halving = 0; halving < 8; ++halving, fraction /= 2) {
      MechanismState<double> trial = state;
      move(trial, fraction * change);
      if (const double size = violation(mechanism, trial); size < last) {
        state = std::move(trial);
        last = size;
        return true;
      }
    }
    return false;
  };
  for (int step = 0; step < most_steps && last > 0; ++step) {
    // rows that depend on each other do so only where they hold: as far as they are from that, what they
    // differ by is no direction to move in
    const double trusted = std::clamp(10 * last / length, rank_tolerance, 0.03);
    if (!improves(trusted) && !(trusted > rank_tolerance && improves(rank_tolerance))) return;
  }
}

/// From one state to another: displacement and body-frame rotation vector of every body.
VectorX<double> displacement(const MechanismState<double>& from, const MechanismState<double>& to) {
  VectorX<double> d(6 * static_cast<Eigen::Index>(to.pose.size()));
  for (std::size_t b = 0; b < to.pose.size(); ++b) {
    const Eigen::Index at = static_cast<Eigen::Index>(6 * b);
    Vector4<double> inverse = -from.pose[b].p;
    inverse[0] = -inverse[0];
    Vector4<double> turn = multiply_parameters<double>(inverse, to.pose[b].p);
    if (turn[0] < 0) turn = -turn;
    const double sine = turn.tail<3>().norm();
    const double factor = sine > 1e-12 ? 2 * std::atan2(sine, turn[0]) / sine : 2.0;
    d.segment<3>(at) = to.pose[b].r - from.pose[b].r;
    d.segment<3>(at + 3) = factor * turn.tail<3>();
  }
  return d;
}

double mass_norm(const Mechanism<double>& mechanism, const VectorX<double>& d) {
  double sum = 0;
  for (int b = 0; b < mechanism.nb(); ++b) {
    const auto& [mass, J] = mechanism.bodies[b];
    const Vector3<double> turn = d.segment<3>(6 * b + 3);
    sum += mass * d.segment<3>(6 * b).squaredNorm() + turn.dot(J * turn);
  }
  return std::sqrt(sum);
}

/// Along the constraints to the state nearest the start: what of the way from there lies along them is
/// undone.
void approach(const Mechanism<double>& mechanism, const MechanismState<double>& start,
              MechanismState<double>& state) {
  constexpr int most_steps = 50;
  VectorX<double> way = displacement(start, state);
  for (int step = 0; step < most_steps; ++step) {
    const TangentSystem system = tangent_system(mechanism, state);
    const VectorX<double> back = least_change(system, system.Phi * way) - way;
    const double distance = mass_norm(mechanism, way);
    if (!(mass_norm(mechanism, back) > 1e-9 * distance)) return;
    bool nearer = false;
    for (double fraction = 1; fraction > 0.1 && !nearer; fraction /= 2) {
      MechanismState<double> trial = state;
      move(trial, fraction * back);
      close_gaps(mechanism, trial);
      const VectorX<double> trial_way = displacement(start, trial);
      nearer =
          check_consistency(mechanism, trial).holds_positions() && mass_norm(mechanism, trial_way) < distance;
      if (!nearer) continue;
      state = std::move(trial);
      way = trial_way;
    }
    if (!nearer) return;
  }
}

}  // namespace

MechanismState<double> assemble(const Mechanism<double>& mechanism, MechanismState<double> state) {
  if (mechanism.nc() == 0) return state;
  const MechanismState<double> start = state;
  close_gaps(mechanism, state);
  if (check_consistency(mechanism, state).holds_positions()) approach(mechanism, start, state);
  project_velocities(mechanism, state);
  const Consistency result = check_consistency(mechanism, state);
  if (!result.holds()) {
    const bool branch_alone = result.holds_rows();
    throw ModelError("the scene cannot be assembled from here: these " +
                     std::string(branch_alone ? "joints hold on a wrong branch" : "rows are not met") + "\n" +
                     result.report() +
                     (branch_alone ? wrong_branch_advice
                                   : "move the bodies closer to where the joints hold, or remove a row that "
                                     "contradicts the others"));
  }
  return state;
}

}  // namespace trivium
