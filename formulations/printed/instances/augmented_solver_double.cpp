/// Compiles the augmented systems of all formulations in double.

#include "formulations/printed/instances/augmented_solver.hpp"

TRIVIUM_AUGMENTED_SOLVER(double)
