#pragma once
/// Estimates the error of a printed solution with the same equations in the next precision. The estimate
/// includes the errors of forming the matrix as well as those of solving.

#include "formulations/printed/augmented_solver.hpp"

namespace trivium {

/// Estimated relative errors [-]. If no digit of the solution is known, the estimate is 1/u or more.
struct ErrorEstimate {
  double lambda = 0, acceleration = 0;
};

/// Estimated errors above this are warned of: fewer than six digits are then certain.
inline constexpr double uncertain_from = 1e-6;

/// The relative errors of a reduced solution x, in the norms of comparison.hpp. `higher` is formed from the
/// same data in the next precision, so its residual at x contains all errors of forming and solving in S.
/// Iterative refinement with this residual and the factors in S gives a more precise solution. Its distance
/// from x is the error.
///
/// The estimate is u + 2 (d + c + a): d is this distance, c the last correction of the refinement, and a the
/// influence of the choice of the omitted rows. a is 0 without dependent rows, and matters where rows are
/// dependent only to the rounding of the scene's numbers.
template <EquationsAsPrinted F, EquationsAsPrinted Higher>
ErrorEstimate estimate_error(const AugmentedSolver<F>& solver, const VectorX<typename F::Scalar>& x,
                             const AugmentedEquations<Higher>& higher);

}  // namespace trivium
