/// Closes the gaps of the joints by a Gauss-Newton iteration, then moves along the constraints to the nearest
/// state, then projects the velocities. All steps are least changes in the mass metric.

#include "formulations/analysis/assemble.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "bodies/rotations/so3.hpp"
#include "formulations/analysis/mass_metric.hpp"
#include "formulations/analysis/rank_tolerance.hpp"

namespace trivium {

namespace {

using F = ROmega<double>;

EquationsOfMotion<F> equations(const Mechanism<double>& mechanism, const MechanismState<double>& state) {
  return equations_of_motion<F>(mechanism, to_coordinates<F>(mechanism, state, {}), state.t);
}

/// The smallest change x in the mass metric with Phi x = c (least squares if rows contradict each other).
VectorX<double> least_change(const TangentSystem& system, const VectorX<double>& c,
                             double threshold = standard_rank_tolerance) {
  const MassMetric metric(system);
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

}  // namespace

void project_velocities(const Mechanism<double>& mechanism, MechanismState<double>& state) {
  for (int pass = 0; pass < 2; ++pass) {  // the second pass removes rounding errors of the first
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

/// Gauss-Newton iteration down to rounding. A step that does not reduce the violation is halved, up to seven
/// times, since a direction that does not help at 1/128 of its length does not help at all. Convergence is
/// quadratic near a solution, so 100 steps are reached only far from every solution.
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
    // Redundant rows are dependent only where they hold. Elsewhere their gradients differ by about the
    // relative violation. This difference must not be taken for a direction of motion, so the rank threshold
    // grows with the violation. The factor 10 and the limit 0.03 are chosen by experiment: a smaller
    // threshold takes the difference for a direction, a larger one leaves out rows that meet at small angles.
    const double trusted = std::clamp(10 * last / length, standard_rank_tolerance, 0.03);
    if (!improves(trusted) && !(trusted > standard_rank_tolerance && improves(standard_rank_tolerance)))
      return;
  }
}

/// Displacement [m, global] and rotation vector [rad, body frame] of every body from one state to another.
VectorX<double> displacement(const MechanismState<double>& from, const MechanismState<double>& to) {
  VectorX<double> d(6 * static_cast<Eigen::Index>(to.pose.size()));
  for (std::size_t b = 0; b < to.pose.size(); ++b) {
    const Eigen::Index at = static_cast<Eigen::Index>(6 * b);
    Vector4<double> inverse = -from.pose[b].p;
    inverse[0] = -inverse[0];
    Vector4<double> turn = multiply_parameters<double>(inverse, to.pose[b].p);
    if (turn[0] < 0) turn = -turn;
    const double sine = turn.tail<3>().norm();
    // below a sine of 1e-12 the quotient is 2 to rounding, and would be 0 / 0 at 0
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

/// Moves along the constraints to the state nearest to `start`. `way` is the displacement from `start`, and
/// each step removes the component of `way` that is tangential to the constraints. A step is halved up to
/// three times if it does not bring the state nearer. Three halvings and 50 steps are chosen by experiment:
/// fewer steps stop before the nearest state is reached, more cost time where the steps converge slowly.
void approach(const Mechanism<double>& mechanism, const MechanismState<double>& start,
              MechanismState<double>& state) {
  constexpr int most_steps = 50;
  // [-], length of a tangential step relative to the distance. A tangential step s reduces the relative
  // distance by s^2 / 2, which is rounding below 1e-9.
  constexpr double nearest_tolerance = 1e-9;
  VectorX<double> way = displacement(start, state);
  for (int step = 0; step < most_steps; ++step) {
    const TangentSystem system = tangent_system(mechanism, state);
    const VectorX<double> back = least_change(system, system.Phi * way) - way;
    const double distance = mass_norm(mechanism, way);
    if (!(mass_norm(mechanism, back) > nearest_tolerance * distance)) return;
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
    throw ModelError("no consistent state was found from the given positions: these " +
                     std::string(branch_alone ? "joints are on a wrong branch" : "rows are violated") + "\n" +
                     result.report() +
                     (branch_alone ? wrong_branch_advice
                                   : "move the bodies closer to a position that satisfies the joints, or "
                                     "remove a row that contradicts the others"));
  }
  return state;
}

}  // namespace trivium
