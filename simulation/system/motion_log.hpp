#pragma once
/// What may happen to a motion beside its steps: passages through singular positions, and impulses where
/// velocities jump.

#include "bodies/rotations/so3.hpp"

namespace trivium {

/// A position where rows depend on others that do not elsewhere.
struct SingularPassage {
  double t;
  int rows;  ///< that depended on others there and before did not
};

/// Velocities jumped with a driver's.
template <class S>
struct Impulse {
  double t;
  VectorX<S> lambda;  ///< of every row: the integral of its multiplier over the jump
};

}  // namespace trivium
