#pragma once
/// Newton's method as a SUNNonlinearSolver. In contrast to that of SUNDIALS it uses Anderson acceleration for
/// the terms that Newton's matrix leaves out.

#include <sundials/sundials_context.h>

#include "integrators/sundials/owned.hpp"

namespace trivium::integrators::sundials_library {

/// The most iterations in one solve. Chosen by experiment: with the three or four of SUNDIALS the
/// acceleration has no time to act; many more only delay the shorter step after a divergence.
constexpr int most_iterations = 8;

/// Makes this solver. The context must outlive it.
Owned<SUNNonlinearSolver> make_accelerated_newton(SUNContext context);

}  // namespace trivium::integrators::sundials_library
