/// Compiles the augmented systems of all formulations in Quad.

#include "formulations/printed/instances/augmented_solver.hpp"

#include "bodies/numbers/quad.hpp"

TRIVIUM_AUGMENTED_SOLVER(Quad)
