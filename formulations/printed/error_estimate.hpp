#pragma once
/// Estimates the error of a printed solution with the same equations in the next precision. The estimate
/// includes the errors of forming the matrix as well as those of solving.

#include "formulations/printed/augmented_solver.hpp"

namespace trivium {

/// Estimated relative errors [-]; at least 1/u if no digit is known.
struct ErrorEstimate {
  double lambda = 0, acceleration = 0;
};

/// The relative errors of a reduced solution x, in the norms of comparison.hpp. `higher` is formed from the
/// same data in the next precision, so its residual at x contains all errors of forming and solving in S.
/// Iterative refinement with this residual and the factors in S gives a more precise solution; its distance
/// from x is the error.
///
/// Returned is u plus twice the sum of this distance, the last correction and, where rows are dependent only
/// to the rounding of the scene's numbers, the influence of the choice of the omitted rows.
template <EquationsAsPrinted F, EquationsAsPrinted Higher>
ErrorEstimate estimate_error(const AugmentedSolver<F>& solver, const VectorX<typename F::Scalar>& x,
                             const AugmentedEquations<Higher>& higher);

}  // namespace trivium
