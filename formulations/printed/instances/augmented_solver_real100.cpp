#include "formulations/printed/instances/augmented_solver.hpp"

#include "bodies/numbers/real50.hpp"

// Judges solutions in Real50; nothing is solved in it.
TRIVIUM_AUGMENTED_EQUATIONS(Real100)
