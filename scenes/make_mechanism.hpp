#pragma once
/// Turns a scene into a mechanism and its state, in the Scalar type of the computation. Axes are normalised
/// and ranges are checked in that Scalar. A model in more digits is therefore made from the scene again,
/// never cast from a model with fewer digits. Compiled in instances/ for all Scalars from float to Real100.

#include "mechanism/model.hpp"
#include "scenes/scene.hpp"

namespace trivium {

/// The mechanism of a scene in Scalar. The scene must have passed the checks of the reader. Throws ModelError
/// if a number is beyond the range of Scalar.
template <class Scalar>
Mechanism<Scalar> make_mechanism(const scenes::Scene& scene);

/// The poses and twists that the scene states, as the state at time t [s].
template <class Scalar>
MechanismState<Scalar> make_state(const scenes::Scene& scene, Scalar t = Scalar(0));

/// The mechanism and the state of the scene at time t [s].
template <class Scalar>
Model<Scalar> make_model(const scenes::Scene& scene, Scalar t = Scalar(0)) {
  return {make_mechanism<Scalar>(scene), make_state<Scalar>(scene, t)};
}

/// The Euler parameters p [4x1, -] of an orientation, normalised in Scalar.
template <class Scalar>
Vector4<Scalar> euler_parameters_of(const scenes::Orientation& orientation);

}  // namespace trivium
