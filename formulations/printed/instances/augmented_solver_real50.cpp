/// Compiles the augmented systems of all formulations in Real50.

#include "formulations/printed/instances/augmented_solver.hpp"

#include "bodies/numbers/real50.hpp"

TRIVIUM_AUGMENTED_SOLVER(Real50)
