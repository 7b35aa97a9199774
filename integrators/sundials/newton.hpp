#pragma once
/// Newton's method as a SUNNonlinearSolver. In contrast to that of SUNDIALS it uses Anderson acceleration for
/// the terms that Newton's matrix leaves out.

#include <sundials/sundials_context.h>

#include "integrators/sundials/owned.hpp"

namespace trivium::integrators::sundials_library {

/// The most iterations in one solve.
constexpr int most_iterations = 8;

Owned<SUNNonlinearSolver> make_accelerated_newton(SUNContext context);

}  // namespace trivium::integrators::sundials_library
