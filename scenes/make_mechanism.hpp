#pragma once
/// From a scene to what the equations are written over: a mechanism and its state, in the Scalar of the
/// computation. Axes are normalised and ranges checked in that Scalar, so a model in more digits is made from
/// the scene again and never cast from one in fewer. Compiled in instances/, for float to Real100.

#include "mechanism/model.hpp"
#include "scenes/scene.hpp"

namespace trivium {

/// The mechanism of a scene in Scalar. The scene is trusted: the reader has proved it.
template <class Scalar>
Mechanism<Scalar> make_mechanism(const scenes::Scene& scene);

/// The state in the file, taken as the state at time t.
template <class Scalar>
MechanismState<Scalar> make_state(const scenes::Scene& scene, Scalar t = Scalar(0));

/// Mechanism and state in one: the scene at time t.
template <class Scalar>
Model<Scalar> make_model(const scenes::Scene& scene, Scalar t = Scalar(0)) {
  return {make_mechanism<Scalar>(scene), make_state<Scalar>(scene, t)};
}

/// Euler parameters [-] of a stated orientation, unit to the last bit of Scalar.
template <class Scalar>
Vector4<Scalar> euler_parameters_of(const scenes::Orientation& orientation);

}  // namespace trivium
