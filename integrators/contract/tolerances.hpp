#pragma once
/// The two bounds of "small enough": tolerances that a user gives for the error of a step, and the level of
/// rounding. Constraints have no tolerance: projections and Newton iterations correct them down to this
/// level. An iteration that cannot reach it may accept more (a relative 1e-6 in projection_iteration.hpp,
/// 1000 times the level in newton.hpp, radau.hpp, row_projection.hpp and half_explicit.hpp, 64 times
/// in rattle.hpp, and 1e-6 of positions and 1e-3 of velocities there where a violation stands still).

#include <limits>

namespace trivium::integrators {

/// The error of a step in an element of y is measured in units of atol + rtol |element|; atol has the unit of
/// the element. How the errors of all elements are combined depends on the method. Methods that use
/// error_norm.hpp take position_sizes (displacements.hpp) in place of |element| for positions.
struct Tolerances {
  double rtol = 1e-8, atol = 1e-10;
};

/// The bound [-] up to which a violation, relative to the numbers of the model, may be rounding alone: one
/// epsilon for each of the about 16 roundings in the terms of a row.
template <class S>
S rounding() {
  return S(16 * std::numeric_limits<S>::epsilon());
}

}  // namespace trivium::integrators
