#pragma once
/// AccelerationSolver: iterative refinement, its termination, and the size of its corrections. A part of
/// acceleration_solver_impl.hpp.

#include <algorithm>
#include <cmath>

#include "bodies/numbers/lanewise.hpp"
#include "bodies/numbers/scalar.hpp"
#include "formulations/structured/acceleration_solver.hpp"

namespace trivium {

/// Sums over all joints, by component, of the squares of the force and the moment that the multipliers exert
/// on one of the joint's two bodies. The three multipliers of the point of a tree joint enter together as one
/// force, every other multiplier by itself.
template <class S>
struct WrenchSize {
  Padded<S> force = Padded<S>::Zero(), moment = force;

  void add(const PointRows<S>& rows, const Vector6<S>& lambda, int orientations) {
    const Padded<S> f = padded<S>(lambda.template head<3>());
    force += f.cwiseAbs2();
    moment += times<S, 3>(rows.L_child, f).cwiseAbs2();
    for (int k = 0; k < orientations; ++k) moment += (lambda[3 + k] * rows.W_child.col(k)).cwiseAbs2();
  }
  void add(const BodyColumns<S>& C, const Vector6<S>& lambda, int size) {
    for (int k = 0; k < size; ++k) {
      force += (lambda[k] * C.r.col(k)).cwiseAbs2();
      moment += (lambda[k] * C.x.col(k)).cwiseAbs2();
    }
  }
};

template <Formulation F>
void AccelerationSolver<F>::refine() {
  refinement_ = Refinement::as_needed;
  solver_.correct(assembly_.matrix(), right_side_, solution_, step_, step_);
  measure_and_add_step();
}

template <Formulation F>
void AccelerationSolver<F>::refine_as_needed() {
  // Stops if the correction did not fall to half of the one before. Also stops if the next correction would
  // be below `enough` at the same rate now / before: 1e-4 u changes no digit even if the rate becomes worse.
  const double enough = 1e-4 * static_cast<double>(unit_roundoff<S>());
  double before = 3;  // corrections are at most 1, so the first one always counts as a fall
  for (;;) {
    refine();
    const double now = larger(corrections_.acceleration, corrections_.lambda);
    if (!(now < before / 2 && now * now / before > enough)) return;
    before = now;
  }
}

template <Formulation F>
void AccelerationSolver<F>::measure_and_add_step() {
  // The sums are by component and are added up at the end. The loop begins with the links that were solved
  // last, whose numbers are still in the cache.
  Padded<S> moved = Padded<S>::Zero(), size = moved;
  WrenchSize<S> lambda_moved, lambda_size;
  const EliminationPlan& plan = solver_.plan();
  const GraphMatrix<S>& matrix = assembly_.matrix();
  auto joint = assembly_.links().begin();
  for (int n = 0; n < static_cast<int>(plan.links.size()); ++n) {
    const int b = plan.links[n].body;
    const auto add_energy = [&](const BodyPart<S>& a, Padded<S>& sum) {
      sum += mechanism_.bodies[b].mass * a.r.cwiseAbs2() + a.x.cwiseProduct(times<S, 3>(matrix.H[b].xx, a.x));
    };
    add_energy(step_.body[b], moved);
    solution_.body[b] += step_.body[b];
    add_energy(solution_.body[b], size);
    if (joint == assembly_.links().end() || joint->link != n) continue;
    const PointRows<S>& rows = matrix.point[n];
    const int e = joint->edge, orientations = joint->joint.size();
    lambda_moved.add(rows, step_.edge[e], orientations);
    solution_.edge[e] += step_.edge[e];
    lambda_size.add(rows, solution_.edge[e], orientations);
    ++joint;
  }
  for (const int e : candidate_edges_) {
    const GraphEdge& edge = plan.graph.edges[e];
    const EdgeRows<S>& rows = matrix.rows[plan.rows_slot[e]];
    const BodyColumns<S>& C = edge.j == plan.graph.bodies ? rows.C_i : rows.C_j;
    lambda_moved.add(C, step_.edge[e], edge.size());
    solution_.edge[e] += step_.edge[e];
    lambda_size.add(C, solution_.edge[e], edge.size());
  }
  const auto ratio = [](const Padded<S>& differences, const Padded<S>& wholes) {
    const S difference = differences.sum(), whole = wholes.sum();
    return std::sqrt(largest_lane(S(select(difference == S(0), S(0), S(difference / whole)))));
  };
  const double forces = ratio(lambda_moved.force, lambda_size.force),
               moments = ratio(lambda_moved.moment, lambda_size.moment);
  // a correction larger than the solution counts as 1: all of the solution is correction
  const auto share = [](double x) { return x > 1 ? 1.0 : x; };
  corrections_ = {share(ratio(moved, size)),
                  share(std::isnan(moments) ? moments : std::max(forces, moments))};
}

}  // namespace trivium
