#pragma once
/// How far a printed solution is from the exact one, judged by the same equations in the next precision. The
/// estimate sees the errors of forming the matrix as well as those of solving it.

#include "formulations/printed/augmented_solver.hpp"

namespace trivium {

struct ErrorEstimate {
  double lambda = 0, acceleration = 0;
};

/// How far a solution is from that of the same scene in exact arithmetic, relative, in the norms above.
///
/// The next rung of the precision ladder forms the same system from the same data; its residual at x sees
/// every error, those of forming K and b in S included. Substituted through the factors of S and repeated, it
/// gives the solution to well beyond S, and the distance to it is the error. Reported is twice the sum of
/// that distance, of what the last correction leaves in doubt and, where rows are dependent only to the
/// rounding of the scene's numbers, of what leaving out these rows and not others decided; plus u.
template <EquationsAsPrinted F, EquationsAsPrinted Higher>
ErrorEstimate estimate_error(const AugmentedSolver<F>& solver, const VectorX<typename F::Scalar>& x,
                             const AugmentedEquations<Higher>& higher);

}  // namespace trivium
