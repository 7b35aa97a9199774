#pragma once
/// How far a state is from its constraints, and the least change, in the mass metric, that takes it there:
///
///   M x + Phi_q^T mu = 0,   Phi_q x = -Phi  (positions)   or   Phi_q x = -(Phi_q q' - nu)  (velocities)
///
/// which is the acceleration solver's own matrix.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "formulations/acceleration_solver.hpp"

namespace trivium {

template <Formulation F>
class ConstraintProjection {
 public:
  using S = typename F::Scalar;

  /// Shares the solver's factors; redundant rows are those that it found last. The solver must outlive this.
  ConstraintProjection(AccelerationSolver<F>& solver, const S& t)
      : solver_(solver),
        violation_(solver.plan().graph),
        scale_(violation_.edge.size()),
        change_(violation_) {
    find_assemblies();
    const auto& edges = solver.plan().graph.edges;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      scale_[e].setOnes();
      for (int k = 0; k < edges[e].size(); ++k)
        scale_[e][k] = row_scale(solver.mechanism().rows[edges[e].rows[k]], t);
    }
  }

  /// To a state; what follows speaks of it.
  void move(std::span<const BodyState<F>> state, const S& t) {
    t_ = t;
    for (int b = 0; b < solver_.mechanism().nb(); ++b) solver_.assembly().move_body(b, state[b]);
    measure_extents();
  }
  /// The motion has reached the state that the solver's bodies are in.
  void settle() {
    measure_extents();
    for (Extent& extent : extent_) extent.fastest = larger(extent.fastest, extent.speed);
  }

  /// The largest |Phi_k| and |Phi_k'|, in metres or radians (per second) whatever a row's scale.
  S measure_positions() {
    solver_.assembly().positions(t_, violation_);
    return largest_violation(&Extent::length);
  }
  S measure_velocities() {
    solver_.assembly().velocities(t_, violation_);
    return largest_violation(&Extent::speed);
  }
  /// Of the last measure, the largest beside the lengths or speeds of the row's own assembly: rounding is
  /// some u.
  const S& relative() const { return relative_; }
  /// Bodies that rows connect, not through the ground, have the same number.
  int assembly_of(int body) const { return assembly_[body]; }
  /// The row of the last measure.
  const std::string& worst_row() const {
    return solver_.mechanism().row_names[solver_.plan().graph.edges[worst_.edge].rows[worst_.k]];
  }

  /// Factors the matrix at the state.
  void factor() {
    GraphAssembly<F>& assembly = solver_.assembly();
    for (const auto& link : assembly.links()) assembly.assemble_link(link, t_, change_);
    assembly.assemble_closings(t_, change_);
    solver_.factors().find_ranks(Ranks::kept);
    ++factorisations_;
    try {
      solver_.factors().factor(assembly.matrix());
    } catch (const SingularLink& link) {
      throw solver_.named(link, t_);
    }
  }
  long factorisations() const { return factorisations_; }
  /// The change that undoes what was measured last, by the factors at hand.
  void solve() {
    for (Vector6<S>& row : violation_.edge) row = -row;
    solver_.factors().solve(violation_, change_);
  }
  Vector3<S> r_change(int b) const { return unpadded<S>(change_.body[b].r); }
  typename F::Unknown q_change(int b) const {
    return F::increment(solver_.assembly().body()[b], unpadded<S>(change_.body[b].x));
  }

 private:
  /// How large an assembly's numbers are.
  struct Extent {
    S reach{0};  ///< of the points of its joints
    S length{0}, speed{0}, fastest{0};
  };

  void measure_extents() {
    for (Extent& extent : extent_) {
      extent.length = S(0);
      extent.speed =
          extent.fastest / 1000;  // at rest for a moment, velocities are the rounding of what they were
    }
    for (int b = 0; b < solver_.mechanism().nb(); ++b) {
      const auto& body = solver_.assembly().body()[b];
      Extent& extent = extent_[assembly_[b]];
      extent.length = larger(extent.length, S(body.r.norm() + extent.reach));
      extent.speed = larger(extent.speed, S(body.r_dot.norm() + body.omega_bar.norm() * extent.reach));
    }
  }

  void find_assemblies() {
    const Mechanism<S>& mechanism = solver_.mechanism();
    const int nb = mechanism.nb();
    assembly_.resize(nb + 1);
    std::iota(assembly_.begin(), assembly_.end(), 0);
    const auto first = [&](int body) {
      while (assembly_[body] != body) body = assembly_[body];
      return body;
    };
    for (const Joint<S>& joint : mechanism.joints)
      if (joint.i != nb && joint.j != nb) assembly_[first(joint.i)] = first(joint.j);
    for (int b = 0; b <= nb; ++b) assembly_[b] = first(b);
    extent_.resize(nb + 1);
    for (const Joint<S>& joint : mechanism.joints) {
      S& reach = extent_[assembly_[joint.i == nb ? joint.j : joint.i]].reach;
      reach = std::max({reach, S(joint.frame_i.point.norm()), S(joint.frame_j.point.norm())});
    }
  }

  S largest_violation(S Extent::*of_assembly) {
    using std::abs;
    S largest(0);
    relative_ = S(0);
    for (std::size_t e = 0; e < violation_.edge.size(); ++e) {
      const GraphEdge& edge = solver_.plan().graph.edges[e];
      const S made_of = extent_[assembly_[edge.i == solver_.mechanism().nb() ? edge.j : edge.i]].*of_assembly;
      for (int k = 0; k < edge.size(); ++k) {
        const S size = abs(violation_.edge[e][k]) / scale_[e][k];
        if (!(size <= relative_ * made_of)) relative_ = made_of > S(0) ? S(size / made_of) : size;
        if (size <= largest || largest != largest) continue;  // a NaN goes in and stays
        largest = size;
        worst_ = {static_cast<int>(e), k};
      }
    }
    return largest;
  }

  AccelerationSolver<F>& solver_;
  GraphVector<S> violation_;
  std::vector<Vector6<S>> scale_;
  GraphVector<S> change_;
  std::vector<int> assembly_;  ///< by body, the ground last: the first body of its assembly
  std::vector<Extent> extent_;
  S t_{0}, relative_{0};
  EdgeRow worst_{0, 0};
  long factorisations_ = 0;
};

}  // namespace trivium
