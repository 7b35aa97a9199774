#pragma once
/// A model: a mechanism and one of its states, over one Scalar. Formulations, solvers and simulations take a
/// model; scenes/make_mechanism.hpp creates it from a scene.

#include "mechanism/mechanism.hpp"

namespace trivium {

/// A mechanism and its state at one time.
template <class S, class Types = StandardTypes>
struct Model {
  using Scalar = S;
  Mechanism<S, Types> mechanism;
  MechanismState<S> state;
};

}  // namespace trivium
