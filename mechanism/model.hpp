#pragma once
/// What a formulation, a solver or a simulation works on: a mechanism and one state of it, in one Scalar. A
/// scene is made into a model once (scenes/make_mechanism.hpp); from there on it is handed on as a value.

#include "mechanism/mechanism.hpp"

namespace trivium {

template <class S, class Types = StandardTypes>
struct Model {
  using Scalar = S;
  Mechanism<S, Types> mechanism;
  MechanismState<S> state;
};

}  // namespace trivium
