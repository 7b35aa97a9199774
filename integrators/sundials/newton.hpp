#pragma once
/// Newton's method as a SUNNonlinearSolver. Beside SUNDIALS' own it has Anderson's acceleration for what
/// matrices leave out.

#include <sundials/sundials_context.h>

#include "integrators/sundials/owned.hpp"

namespace trivium::integrators::sundials_library {

/// Of one step.
constexpr int most_iterations = 8;

Owned<SUNNonlinearSolver> make_accelerated_newton(SUNContext context);

}  // namespace trivium::integrators::sundials_library
