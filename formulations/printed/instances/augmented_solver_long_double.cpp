/// Compiles the augmented systems of all formulations in long double.

#include "formulations/printed/instances/augmented_solver.hpp"

TRIVIUM_AUGMENTED_SOLVER(long double)
