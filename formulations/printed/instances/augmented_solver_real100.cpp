/// Compiles the augmented systems of all formulations in Real100.

#include "formulations/printed/instances/augmented_solver.hpp"

#include "bodies/numbers/real50.hpp"

// Real100 estimates the errors of solutions in Real50, and no system is solved in Real100.
TRIVIUM_AUGMENTED_EQUATIONS(Real100)
