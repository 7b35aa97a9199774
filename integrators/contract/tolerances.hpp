#pragma once
/// The two measures of "small enough": the errors that a user allows in each step, and what rounding leaves.
/// Constraints have no tolerance: projections and Newton's methods meet them to rounding.

#include <limits>

namespace trivium::integrators {

/// Errors of each number of y up to atol + rtol |number|, per step.
struct Tolerances {
  double rtol = 1e-8, atol = 1e-10;
};

/// What rounding may leave of a measure beside the model's own numbers.
template <class S>
S rounding() {
  return S(16 * std::numeric_limits<S>::epsilon());
}

}  // namespace trivium::integrators
