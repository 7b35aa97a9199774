#pragma once
/// The state of a mechanism in the coordinates of one formulation: the state of one body in its chart, the
/// kinematics of all bodies, and the wrenches that the effects apply to the bodies. The kinematics
/// (positions, rotations, velocities and biases) are computed once per state; rows and effects read the
/// same ones.

#include <vector>

#include "bodies/rigid_body.hpp"
#include "formulations/formulation.hpp"
#include "mechanism/mechanism.hpp"

namespace trivium {

/// The state of one body: position r [m, global] and velocity r' [m/s, global] of its centre of mass, and q,
/// the rotational coordinates and velocities of the formulation (A and omega_bar, p and p', or epsilon and
/// epsilon') in the chart that is chosen for the body.
template <EquationsAsPrinted F>
struct BodyState {
  Vector3<typename F::Scalar> r, r_dot;
  typename F::Chart chart;
  typename F::Coordinates q;
};

/// The kinematics of one body in its chart.
template <EquationsAsPrinted F>
typename F::Kinematics kinematics_of(const BodyState<F>& body) {
  return F::kinematics(body.chart, body.r, body.r_dot, body.q);
}

/// The coordinates of all bodies without the ground, each in the chart that the formulation chooses by
/// `options`. Throws a ModelError that names the body if its chart is singular at this state.
template <EquationsAsPrinted F, class Types>
std::vector<BodyState<F>> to_coordinates(const Mechanism<typename F::Scalar, Types>& mechanism,
                                         const MechanismState<typename F::Scalar>& state,
                                         const ChartOptions& options);

/// The kinematics of all bodies; the last entry is the ground.
template <EquationsAsPrinted F>
std::vector<typename F::Kinematics> body_kinematics(const std::vector<BodyState<F>>& bodies);

/// The applied wrench of each body: force [N, global] and moment about its centre of mass [N m, body
/// frame]; the last entry is the ground.
template <class Kinematics, class Scalar, class Types>
std::vector<Wrench<Scalar>> applied_wrenches(const Mechanism<Scalar, Types>& mechanism,
                                             const std::vector<Kinematics>& body, const Scalar& t) {
  const std::vector<BodyMotion<Scalar>> motion(body.begin(), body.end());
  std::vector<Wrench<Scalar>> wrenches(body.size());
  mechanism.effects.apply(EffectView<Scalar>{mechanism.bodies, motion, t}, wrenches);
  return wrenches;
}

}  // namespace trivium
