/// Compiles the augmented systems of all formulations in float.

#include "formulations/printed/instances/augmented_solver.hpp"

TRIVIUM_AUGMENTED_SOLVER(float)
