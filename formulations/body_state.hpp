#pragma once
/// The state of a mechanism in a formulation's coordinates: one body in its chart, the kinematics of all
/// bodies, and the wrenches that the effects apply to them. Kinematics (A, omega, omega' up to accelerations)
/// are formed once and given to rows and effects alike.

#include <vector>

#include "bodies/rigid_body.hpp"
#include "formulations/formulation.hpp"
#include "mechanism/mechanism.hpp"

namespace trivium {

/// One body in a formulation's coordinates, in the chart chosen for it.
template <EquationsAsPrinted F>
struct BodyState {
  Vector3<typename F::Scalar> r, r_dot;
  typename F::Chart chart;
  typename F::Coordinates q;
};

template <EquationsAsPrinted F>
typename F::Kinematics kinematics_of(const BodyState<F>& body) {
  return F::kinematics(body.chart, body.r, body.r_dot, body.q);
}

/// The state of a mechanism in a formulation's coordinates; throws a ModelError that names the body whose
/// chart is singular.
template <EquationsAsPrinted F, class Types>
std::vector<BodyState<F>> to_coordinates(const Mechanism<typename F::Scalar, Types>& mechanism,
                                         const MechanismState<typename F::Scalar>& state,
                                         const ChartOptions& options);

/// The kinematics of all bodies, the ground's last.
template <EquationsAsPrinted F>
std::vector<typename F::Kinematics> body_kinematics(const std::vector<BodyState<F>>& bodies);

/// The applied wrenches of all bodies, the ground's last.
template <class Kinematics, class Scalar, class Types>
std::vector<Wrench<Scalar>> applied_wrenches(const Mechanism<Scalar, Types>& mechanism,
                                             const std::vector<Kinematics>& body, const Scalar& t) {
  const std::vector<BodyMotion<Scalar>> motion(body.begin(), body.end());
  std::vector<Wrench<Scalar>> wrenches(body.size());
  mechanism.effects.apply(EffectView<Scalar>{mechanism.bodies, motion, t}, wrenches);
  return wrenches;
}

}  // namespace trivium
