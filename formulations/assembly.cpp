#include "formulations/assembly.hpp"

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
struct Magnitudes {
  double length = 0, speed = 0;
};

Magnitudes magnitudes(const Mechanism<double>& mechanism, const MechanismState<double>& state) {
  Magnitudes m;
  for (const auto& pose : state.pose) m.length = std::max(m.length, pose.r.norm());
  for (const auto& joint : mechanism.joints)
    m.length = std::max({m.length, joint.frame_i.point.norm(), joint.frame_j.point.norm()});
  if (m.length == 0) m.length = 1;
  for (const auto& twist : state.twist)
    m.speed = std::max({m.speed, twist.r_dot.norm(), twist.omega_bar.norm() * m.length});
  return m;
}

double row_norm(const EquationsOfMotion<F>::Row& row, double length, bool holds_points) {
  const double translation = row.r_i.squaredNorm() + row.r_j.squaredNorm();
  const double rotation = row.rot_i.squaredNorm() + row.rot_j.squaredNorm();
  const double norm = std::sqrt(holds_points ? translation + rotation / (length * length) : rotation);
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
  using Type = scenes::ConstraintType;
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

bool holds_points(const Mechanism<double>& mechanism, int k) {
  return !std::holds_alternative<DP1<double>>(mechanism.rows[k]) &&
         !std::holds_alternative<TurningDP1<double>>(mechanism.rows[k]);
}

/// The least change x, in the metric, with Phi x = c (least squares where rows contradict each other).
VectorX<double> least_change(const TangentSystem& system, const VectorX<double>& c) {
  const Metric metric(system);
  MatrixX<double> W = metric.half_solve(system.Phi.transpose());
  VectorX<double> scale = W.colwise().norm().transpose();
  for (double& s : scale) s = s > 0 ? 1 / s : 0.0;
  W = W * scale.asDiagonal();
  Eigen::CompleteOrthogonalDecomposition<MatrixX<double>> decomposition;
  decomposition.setThreshold(rank_tolerance);
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

void append_offenders(std::string& text, const std::vector<Violation>& violations, const char* what,
                      double tolerance) {
  std::vector<Violation> bad;
  for (const Violation& v : violations)
    if (v.exceeds) bad.push_back(v);
  std::sort(bad.begin(), bad.end(), [](const Violation& a, const Violation& b) { return a.size > b.size; });
  for (const Violation& v : bad)
    text += fmt::format("  {} {}: residual {:.3e} (tolerance {:.1e})\n", v.row, what, v.residual, tolerance);
}

}  // namespace

bool Consistency::holds() const {
  const auto exceeds = [](const Violation& v) { return v.exceeds; };
  return wrong_branches.empty() && std::none_of(positions.begin(), positions.end(), exceeds) &&
         std::none_of(velocities.begin(), velocities.end(), exceeds);
}

std::string Consistency::report() const {
  std::string text;
  append_offenders(text, positions, "position", position_tolerance);
  append_offenders(text, velocities, "velocity", velocity_tolerance);
  for (const std::string& branch : wrong_branches) text += fmt::format("  {} (a wrong branch)\n", branch);
  return text;
}

Consistency check_consistency(const Mechanism<double>& mechanism, const MechanismState<double>& state) {
  const auto eom = equations(mechanism, state);
  const Magnitudes m = magnitudes(mechanism, state);
  Consistency out;
  out.position_tolerance = 1e-8;
  out.velocity_tolerance = 1e-8;
  const VectorX<double> velocity = velocity_residual(eom);
  for (int k = 0; k < eom.nc(); ++k) {
    const bool points = holds_points(mechanism, k);
    const double norm = row_norm(eom.row[k], m.length, points);
    const double length = points ? m.length : 1.0, speed = points ? m.speed : m.speed / m.length;
    const auto violation = [&](double residual, double tolerance) {
      const double size = std::abs(residual) / norm;
      return Violation{mechanism.row_names[k], residual, size, !(size <= tolerance)};
    };
    out.positions.push_back(violation(eom.row[k].phi, out.position_tolerance * length));
    out.velocities.push_back(violation(velocity[k], out.velocity_tolerance * speed + 1e-12 * length));
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

MechanismState<double> assemble(const Mechanism<double>& mechanism, MechanismState<double> state) {
  if (mechanism.nc() == 0) return state;
  const auto violation = [&](const MechanismState<double>& s) {
    return worst_size(check_consistency(mechanism, s).positions);
  };
  constexpr int most_steps = 100;
  double last = violation(state);
  for (int step = 0; step < most_steps && last > 0; ++step) {
    const VectorX<double> change =
        least_change(tangent_system(mechanism, state), -positions_residual(equations(mechanism, state)));
    // halve a step that does not help; at the rounding level none does, and that is the end
    double fraction = 1;
    MechanismState<double> trial = state;
    double size = last;
    for (int halving = 0; halving < 8; ++halving, fraction /= 2) {
      trial = state;
      move(trial, fraction * change);
      size = violation(trial);
      if (size < last) break;
    }
    if (!(size < last)) break;
    state = trial;
    last = size;
  }
  project_velocities(mechanism, state);
  const Consistency result = check_consistency(mechanism, state);
  if (!result.holds())
    throw ModelError(
        "the scene cannot be assembled from here: these rows are not met\n" + result.report() +
        "move the bodies closer to where the joints hold, or remove a row that contradicts the others");
  return state;
}

}  // namespace trivium
