#pragma once
/// The state of a mechanism in a formulation's coordinates: one body in its chart, the kinematics of all
/// bodies, and the wrenches that the effects apply to them.

#include <vector>

#include "base/error.hpp"
#include "formulations/formulation.hpp"
#include "mechanism/mechanism.hpp"

namespace trivium {

/// One body in a formulation's coordinates, in the chart chosen for it.
template <Formulation F>
struct BodyState {
  Vector3<typename F::Scalar> r, r_dot;
  typename F::Chart chart;
  typename F::Coordinates q;
};

/// The state of a mechanism in a formulation's coordinates; throws a ModelError that names the body whose
/// chart is singular.
template <Formulation F>
std::vector<BodyState<F>> to_coordinates(const Mechanism<typename F::Scalar>& mechanism,
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
      throw ModelError(fmt::format("body \"{}\": {}", mechanism.body_names[b], error.what()));
    }
  }
  return bodies;
}

/// The kinematics of all bodies, the ground's last.
template <Formulation F>
std::vector<typename F::Kinematics> body_kinematics(const std::vector<BodyState<F>>& bodies) {
  using S = typename F::Scalar;
  std::vector<typename F::Kinematics> kinematics;
  kinematics.reserve(bodies.size() + 1);
  for (const BodyState<F>& b : bodies) kinematics.push_back(F::kinematics(b.chart, b.r, b.r_dot, b.q));
  // the ground has no unknowns, so any regular chart serves it
  const Vector3<S> zero = Vector3<S>::Zero();
  const Vector4<S> upright = Vector4<S>::Unit(0);
  const typename F::Chart chart = F::choose_chart(ChartOptions{}, upright);
  kinematics.push_back(F::kinematics(chart, zero, zero, F::from_pose(chart, upright, zero)));
  // upright to the last bit: an angle of 90 degrees has none, and the ground's points may be far away
  kinematics.back().A.setIdentity();
  return kinematics;
}

/// The applied wrenches of all bodies, the ground's last.
template <class Kinematics, class Scalar>
std::vector<Wrench<Scalar>> applied_wrenches(const Mechanism<Scalar>& mechanism,
                                             const std::vector<Kinematics>& body, const Scalar& t) {
  const std::vector<BodyMotion<Scalar>> motion(body.begin(), body.end());
  std::vector<Wrench<Scalar>> wrenches(body.size());
  mechanism.effects.apply(EffectView<Scalar>{mechanism.bodies, motion, t}, wrenches);
  return wrenches;
}

}  // namespace trivium
