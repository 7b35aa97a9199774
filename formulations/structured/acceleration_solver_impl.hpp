#pragma once
/// The complete definition of AccelerationSolver, for a Scalar without instances, and for your own
/// formulations, constraints or effects. This file has the sequence of a solution: bodies, forces, closings,
/// elimination, refinement, check of the dependent rows. Parts: refinement_impl.hpp,
/// dependent_rows_check_impl.hpp, unique_multipliers_impl.hpp.

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "bodies/numbers/scalar.hpp"
#include "formulations/r_epsilon.hpp"
#include "formulations/r_epsilon_omega_first.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/r_p.hpp"
#include "formulations/structured/acceleration_solver.hpp"
#include "formulations/structured/dependent_rows_check_impl.hpp"
#include "formulations/structured/graph_assembly_impl.hpp"
#include "formulations/structured/refinement_impl.hpp"
#include "formulations/structured/unique_multipliers_impl.hpp"

namespace trivium {

template <Formulation F>
AccelerationSolver<F>::AccelerationSolver(const MechanismOf<F>& mechanism)
    : mechanism_(mechanism),
      solver_(plan_elimination(body_joint_graph(mechanism))),
      assembly_(mechanism, solver_.plan()),
      right_side_(solver_.plan().graph),
      solution_(right_side_),
      residual_(right_side_),
      step_(right_side_),
      wrenches_(mechanism.nb() + 1),
      motion_(mechanism.nb() + 1) {
  for (int e = 0; e < static_cast<int>(plan().graph.edges.size()); ++e)
    if (plan().rows_slot[e] >= 0) candidate_edges_.push_back(e);
}

template <Formulation F>
void AccelerationSolver<F>::solve(std::span<const BodyState<F>> state, const S& t, Refinement refinement,
                                  DependentRows how) {
  try {
    rows_are_decided_ = how != DependentRows::detect;
    t_ = t;
    refinement_ = refinement;
    move_bodies(state);
    if (baumgarte_) measure_violations();
    start(how);
    eliminate();
    if (how == DependentRows::detect_near_singular) exchange_weak_rows();
    solver_.substitute(solution_);
    if (solver_.restore_kept_rows()) solver_.solve(right_side_, solution_);
    if (refinement == Refinement::as_needed) refine_as_needed();
    if (how == DependentRows::detect) check_dependent_rows();
  } catch (...) {
    forget();
    throw;
  }
}

template <Formulation F>
void AccelerationSolver<F>::start(DependentRows how) {
  solver_.set_dependent_rows(how);
  if (how == DependentRows::detect_near_singular)
    assembly_.find_vanishing_rows(S(vanishing_row_tolerance),
                                  [&](int edge, int k) { solver_.mark_dependent(edge, k); });
  assembly_.assemble_closings(t_, right_side_);
  if (baumgarte_)
    for (const int e : candidate_edges_) stabilise(e);
  solver_.start(assembly_.matrix(), right_side_);
}

template <Formulation F>
void AccelerationSolver<F>::exchange_weak_rows() {
  const int found = solver_.dependent_row_count();
  if (found == 0 || !(solver_.weakest_pivot() < S(weak_pivot))) return;
  for (const bool without : {true, false}) {
    start(DependentRows::detect_near_singular);
    if (without) solver_.leave_out_below(S(weak_pivot));
    eliminate();
    if (solver_.dependent_row_count() == found) return;
  }
}

template <Formulation F>
void AccelerationSolver<F>::stabilise(const Baumgarte& baumgarte) {
  baumgarte_ = baumgarte;
  phi_.emplace(plan().graph);
  phi_dot_.emplace(plan().graph);
}

template <Formulation F>
void AccelerationSolver<F>::measure_violations() {
  assembly_.positions(t_, *phi_);
  assembly_.velocities(t_, *phi_dot_);
}

template <Formulation F>
void AccelerationSolver<F>::stabilise(int edge) {
  const auto& [alpha, beta] = *baumgarte_;
  right_side_.edge[edge] -= S(2 * alpha) * phi_dot_->edge[edge] + S(beta * beta) * phi_->edge[edge];
}

template <Formulation F>
void AccelerationSolver<F>::move_bodies(std::span<const BodyState<F>> state) {
  const bool effects_see_motion = mechanism_.effects.see_motion();
  if (!effects_see_motion) apply_effects();
  for (int b = 0; b < mechanism_.nb(); ++b) {
    assembly_.move_body(b, state[b]);
    if (!effects_see_motion) push_body(b);
  }
  if (!effects_see_motion) return;
  std::copy(assembly_.body().begin(), assembly_.body().end(), motion_.begin());
  apply_effects();
  for (int b = 0; b < mechanism_.nb(); ++b) push_body(b);
}

template <Formulation F>
[[gnu::flatten]] void AccelerationSolver<F>::push_body(int b) {
  const Wrench<S>& wrench = wrenches_[b];
  const Vector3<S> force = F::reduced_force(assembly_.body()[b], mechanism_.bodies[b].inertia, wrench.n_bar);
  right_side_.body[b] = {padded<S>(wrench.F), padded<S>(force)};
}

template <Formulation F>
void AccelerationSolver<F>::apply_effects() {
  for (Wrench<S>& w : wrenches_) w = {};
  mechanism_.effects.apply(EffectView<S>{mechanism_.bodies, motion_, t_}, wrenches_);
}

template <Formulation F>
void AccelerationSolver<F>::eliminate() {
  const auto& links = assembly_.links();
  auto joint = links.begin();
  try {
    for (int step = 0; step < solver_.steps(); ++step) {
      if (joint != links.end() && joint->link == plan().steps[step].link) assemble_link(*joint++);
      solver_.eliminate(step, right_side_);
    }
  } catch (const SingularLink& e) {
    throw named(e, t_);
  }
}

template <Formulation F>
void AccelerationSolver<F>::assemble_link(const typename GraphAssembly<F>::LinkJoint& link) {
  assembly_.assemble_link(link, t_, right_side_);
  if (baumgarte_) stabilise(link.edge);
}

template <Formulation F>
std::vector<int> AccelerationSolver<F>::dependent_rows() {
  decide_dependent_rows();
  std::vector<int> rows;
  for_each_row([&](int edge, int k, int row) {
    if (solver_.is_dependent(edge, k)) rows.push_back(row);
  });
  std::sort(rows.begin(), rows.end());
  return rows;
}

template <Formulation F>
int AccelerationSolver<F>::weak_rows_by_geometry() {
  int vanishing = 0;
  assembly_.find_vanishing_rows(S(vanishing_row_tolerance), [&](int, int) { ++vanishing; });
  return vanishing + solver_.weak_rows_by_geometry();
}

template <Formulation F>
ModelError AccelerationSolver<F>::named(const SingularLink& link, const S& t) const {
  require_numbers();
  return ModelError(
      {fmt::format("body \"{}\"", mechanism_.body_names[link.body()]), static_cast<double>(t)},
      fmt::format("{}; the structured solver cannot eliminate this body: give it inertia in this motion, or "
                  "constrain this motion by the joint to its parent",
                  link.what()));
}

template <Formulation F>
void AccelerationSolver<F>::require_numbers() const {
  using std::isfinite;
  for (int b = 0; b < mechanism_.nb(); ++b) {
    const AngularMotion<S>& turning = assembly_.angular_motion()[b];
    const Body& body = assembly_.body()[b];
    if (!isfinite(S(turning.A.sum() + turning.omega.sum() + body.r.sum() + body.r_dot.sum())))
      throw ModelError({fmt::format("body \"{}\"", mechanism_.body_names[b]), static_cast<double>(t_)},
                       "the state of the body is not finite");
  }
}

template <Formulation F>
void AccelerationSolver<F>::forget() {
  const S nothing = std::numeric_limits<S>::quiet_NaN();
  for (BodyPart<S>& part : solution_.body) {
    part.r.setConstant(nothing);
    part.x.setConstant(nothing);
  }
  for (Vector6<S>& lambda : solution_.edge) lambda.setConstant(nothing);
  corrections_ = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
}

// a translation unit that instantiates for another Scalar does not instantiate for double again
extern template class GraphAssembly<ROmega<double>>;
extern template class GraphAssembly<RP<double>>;
extern template class GraphAssembly<REpsilon<double>>;
extern template class GraphAssembly<REpsilonOmegaFirst<double>>;
extern template class AccelerationSolver<ROmega<double>>;
extern template class AccelerationSolver<RP<double>>;
extern template class AccelerationSolver<REpsilon<double>>;
extern template class AccelerationSolver<REpsilonOmegaFirst<double>>;

}  // namespace trivium
