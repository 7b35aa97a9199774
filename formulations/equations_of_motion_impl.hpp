#pragma once
/// The definitions of the function templates of body_state.hpp and equations_of_motion.hpp. The library
/// compiles them in instances/, for float to Real100. Include this file for a Scalar without an instance,
/// such as a Batch, and for your own formulations, constraints or effects.

#include <fmt/format.h>

#include "base/error.hpp"
#include "constraints/constraint_row.hpp"
#include "formulations/equations_of_motion.hpp"

namespace trivium {

template <EquationsAsPrinted F, class Types>
std::vector<BodyState<F>> to_coordinates(const Mechanism<typename F::Scalar, Types>& mechanism,
                                         const MechanismState<typename F::Scalar>& state,
                                         const ChartOptions& options) {
  std::vector<BodyState<F>> bodies;
  bodies.reserve(mechanism.bodies.size());
  for (int b = 0; b < mechanism.nb(); ++b) {
    const auto& pose = state.pose[b];
    const auto& twist = state.twist[b];
    try {
      const typename F::Chart chart = F::choose_chart(options, pose.p);
      bodies.push_back({pose.r, twist.r_dot, chart, F::from_pose(chart, pose.p, twist.omega_bar)});
    } catch (const ModelError& error) {
      throw ModelError({fmt::format("body \"{}\"", mechanism.body_names[b]), static_cast<double>(state.t)},
                       error);
    }
  }
  return bodies;
}

template <EquationsAsPrinted F>
std::vector<typename F::Kinematics> body_kinematics(const std::vector<BodyState<F>>& bodies) {
  using S = typename F::Scalar;
  std::vector<typename F::Kinematics> kinematics;
  kinematics.reserve(bodies.size() + 1);
  for (const BodyState<F>& b : bodies) kinematics.push_back(kinematics_of(b));
  // the ground has no unknowns, so any regular chart can be used
  const Vector3<S> zero = Vector3<S>::Zero();
  const Vector4<S> upright = Vector4<S>::Unit(0);
  const typename F::Chart chart = F::choose_chart(ChartOptions{}, upright);
  kinematics.push_back(F::kinematics(chart, zero, zero, F::from_pose(chart, upright, zero)));
  // The chart of the upright ground may use an angle of 90 degrees, whose sine and cosine are rounded. With
  // an exact A the points of the ground stay exact, however far from the origin they are
  kinematics.back().A.setIdentity();
  return kinematics;
}

template <EquationsAsPrinted F, class Types>
EquationsOfMotion<F> equations_of_motion(const Mechanism<typename F::Scalar, Types>& mechanism,
                                         const std::vector<BodyState<F>>& bodies,
                                         const typename F::Scalar& t) {
  EquationsOfMotion<F> eom;
  eom.t = t;
  eom.body = body_kinematics(bodies);
  const auto wrenches = applied_wrenches(mechanism, eom.body, t);
  for (int b = 0; b < mechanism.nb(); ++b) {
    const auto& J_bar = mechanism.bodies[b].inertia;
    eom.mass.push_back(mechanism.bodies[b].mass);
    eom.mass_block.push_back(F::mass_block(eom.body[b], J_bar));
    eom.F_applied.push_back(wrenches[b].F);
    eom.tau.push_back(F::applied_force(eom.body[b], wrenches[b].n_bar) +
                      F::velocity_force(eom.body[b], J_bar));
  }
  for (const auto& constraint : mechanism.rows) {
    const BodyPair pair = bodies_of(constraint);
    eom.pair.push_back(pair);
    eom.row.push_back(evaluate_row(constraint, eom.body[pair.i], eom.body[pair.j], t));
  }
  return eom;
}

}  // namespace trivium
